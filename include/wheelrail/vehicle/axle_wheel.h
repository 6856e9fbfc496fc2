#pragma once

#include <wheelrail/wheel/halfspace_case.h>

#include <memory>
#include <string>

namespace wheelrail
{
  /// One wheel of a wheelset on its rail. A left one is seen as its mirror image (Wheelset/Side).
  struct WheelOnAxle
  {
    Scene         scene;
    SceneGeometry geometry;
    double        load = 0; ///< vertical [N]; 0: it does not touch
  };

  /// What presses a wheel that turns with a pitch rate over the velocity of the wheelset's middle [1/m].
  WheelRailLoad
  rolling_load(const WheelOnAxle &wheel, double rate);

  /// One loaded wheel while the pitch rate of its axle is searched for.
  class AxleWheel
  {
  public:
    virtual ~AxleWheel() = default;

    /// Rolls with a pitch rate over the velocity of the wheelset's middle [1/m], pressed as the last call of
    /// carried() asked for; the torque that keeps the wheel turning so [N m].
    virtual double
    roll(double rate) = 0;

    /// Whether the wheel carries its load as it rolled last.
    virtual bool
    carried() = 0;

    /// By how much the load was missed, over the load.
    virtual double
    missed() const = 0;

    /// As it rolled last; `within_friction` and `not_found` say how the search for the rate ended.
    virtual WheelRailSolution
    result(bool within_friction, const std::string &not_found) const = 0;
  };

  /// With half-spaces, which may touch in several places, or with the true bodies, as the wheel's scene has
  /// it (Half-space/Bodies); `rate` [1/m] for the first guess. The wheel must outlive it. Throws InputError
  /// for sections that have no tables.
  std::unique_ptr<AxleWheel>
  make_axle_wheel(const WheelOnAxle &wheel, double rate);
} // namespace wheelrail
