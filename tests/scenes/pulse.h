#pragma once

// A pulse that runs along a bar and is reflected at its end.

#include "dynamics.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace scenes
{
  constexpr double bar_length = 0.2; ///< [m]

  enum class End
  {
    free,
    fixed
  };

  /// A bar of cubes along x; `confined`: no displacement across, as in a block that fills a half-space.
  struct Bar
  {
    Setup        setup;
    unsigned int cells    = 100;
    bool         confined = false;
    End          end      = End::free;

    /// Of the wave (Timoshenko and Goodier, Theory of Elasticity, 3rd edition 1970, chapter 14) [m/s].
    double
    speed() const
    {
      const Elasticity &m = setup.material;
      return confined ? m.wave_speed() : std::sqrt(m.youngs_modulus / m.density);
    }

    /// Edge of its cubes [m].
    double
    height() const
    {
      return bar_length / cells;
    }

    std::string
    name() const
    {
      return form_name(setup) + (confined ? " block" : " bar") +
             (end == End::free ? ", free end" : ", fixed end");
    }
  };

  /// The bar whose near end moves so.
  class BarScene : public Dynamics
  {
  public:
    BarScene(const Bar &bar, const Function &displacement);
  };

  /// Velocity peak sin^2(pi t/duration) of the loaded end.
  struct Pulse
  {
    double peak, duration;

    double
    velocity(const double t) const
    {
      return t < 0 || t > duration ? 0 : peak * std::pow(std::sin(M_PI * t / duration), 2);
    }
    double
    displacement(double t) const
    {
      t = std::min(std::max(t, 0.), duration);
      return peak * (t / 2 - duration / (4 * M_PI) * std::sin(2 * M_PI * t / duration));
    }
  };

  /// Root mean square over the nodes of the error of d'Alembert's solution after one reflection, over the
  /// largest displacement.
  /// step: near the time step wanted [s].
  double
  pulse_error(const Bar &bar, const Pulse &pulse, double step);
} // namespace scenes
