#pragma once

// A strip in plane strain that repeats itself, over which a Hertzian line load travels again and again:
// shakedown and ratcheting of the program's elements and laws without contact.

#include "dynamics.h"

#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

namespace scenes
{
  /// The pressure p0 sqrt(1 - z2/a2) with the shear traction `traction` times it, which points the path it
  /// goes.
  struct LineLoad
  {
    double       peak     = 0;  ///< p0 [Pa]
    double       traction = 0;  ///< shear traction over pressure
    unsigned int cells    = 10; ///< on the half width a
    unsigned int period   = 10; ///< of the strip, over a
  };

  /// After a pass, over depth: means along the strip.
  struct StripPass
  {
    std::vector<double> strain; ///< accumulated plastic strain [1]
    /// du_z/dy, positive forward at the top: plastic shear strain but for a constant, since the shear stress
    /// has the mean of the traction at all depths [1].
    std::vector<double> shear;
  };

  /// Stresses that are left once the load is off.
  struct StripResidual
  {
    double largest = 0; ///< of the components along and across (z and x), which equilibrium admits [Pa]
    double other   = 0; ///< of the other components, over that
    double spread  = 0; ///< range of these two along the strip at equal depth, over that
  };

  /// The loads of neighbouring periods, 10 a away, bring one per cent of p0 to the depths that yield. The
  /// period also hinders the strip as a whole; what that adds is a constant stress along it, which
  /// equilibrium admits as a residual one, so that limits of shakedown are those of the half-space.
  class RolledStrip
  {
  public:
    /// `setup` holds steel and element, `law` another law of the same elastic constants; damping and bulk
    /// viscosity are set here.
    RolledStrip(const LineLoad                              &load,
                const Setup                                 &setup,
                const std::optional<wheelrail::MaterialLaw> &law = std::nullopt);
    RolledStrip(const RolledStrip &) = delete; // the load refers to it

    /// The load goes on by one period.
    StripPass
    pass();

    /// Takes the load off while it rolls on. Of the strip between `from` and `to` times a.
    StripResidual
    unload(double from, double to);

    /// The largest stresses of elements under a load at rest, over its p0: von Mises', without the constant
    /// stress of the period, and the shear stress yz. For elastic strips.
    std::array<double, 2>
    largest_stresses();

    /// Middles of the upper rows of elements, from the top downwards, over a.
    std::vector<double> depth;

    Dynamics scene;

  private:
    void
    press(double time, double *force) const;

    LineLoad     load_;
    Nodes        top_;
    unsigned int passes_ = 0;
    double       lifted_ = std::numeric_limits<double>::infinity(); ///< place, over a
    std::vector<std::vector<std::size_t>> rows_;                    ///< packed elements along, over depth
  };

  /// Largest over depth of the growth a pass from the state `from` to the state `to`, `n` passes later.
  double
  growth(const std::vector<double> &from, const std::vector<double> &to, double n);
} // namespace scenes
