#pragma once

#include <wheelrail/vehicle/axle_wheel.h>

#include <optional>

namespace wheelrail
{
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
