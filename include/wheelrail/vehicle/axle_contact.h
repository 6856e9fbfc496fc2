#pragma once

#include <wheelrail/wheel/halfspace_case.h>

#include <memory>
#include <optional>
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

  /// What turns an axle.
  struct AxleDrive
  {
    double torque    = 0;     ///< on the axle, positive forward [N m]
    bool   rate_held = false; ///< the creepage of the right-hand wheel is given instead
    double creepage  = 0;     ///< at its rolling radius, positive driving
  };

  /// Two wheels that turn at one rate. Sums have the signs of the right-hand wheel: forces along X count to
  /// the left, moments about the vertical turn the nose to the left.
  struct AxleSolution
  {
    std::optional<WheelRailSolution> right, left; ///< none: without load
    double rate       = 0; ///< pitch rate over the velocity of the wheelset's middle [1/m]
    double torque     = 0; ///< that keeps the axle turning so [N m]; wanted and found differ where it slides
    double lateral    = 0; ///< sum of the forces on the wheels [N]
    double yaw_moment = 0; ///< of both contacts about the vertical through the middle [N m]
  };

  /// Adds up what both wheels do to the wheelset: forces, moments, torque.
  void
  sum_up(AxleSolution &axle);

  /// Solves the steady rolling of a wheelset in its given pose, with half-spaces or with the true bodies
  /// (Half-space/Bodies): each wheel carries its load, both have the one pitch rate at which the torques of
  /// their contacts add up to that of the drive. On a curved path (Track/Radius) the rails come with
  /// different speeds. The wheels may touch their rails in several places. Where friction cannot carry the
  /// torque, the wheels lock or spin up. On two threads each has one wheel.
  AxleSolution
  solve_axle(const WheelOnAxle &right,
             const WheelOnAxle &left,
             const AxleDrive   &drive,
             unsigned int       threads = 1);
} // namespace wheelrail
