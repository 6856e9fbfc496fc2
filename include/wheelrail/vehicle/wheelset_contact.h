#pragma once

#include <wheelrail/model/scene_geometry.h>
#include <wheelrail/scene/curve_loads.h>
#include <wheelrail/vehicle/axle_contact.h>

#include <optional>

namespace wheelrail
{
  /// A wheelset on its track in steady rolling.
  struct WheelsetSolution
  {
    WheelOnAxle  right, left; ///< in the pose and under the loads that were found
    AxleSolution axle;
    CurveLoads   loads;
    double       lateral_missed = 0; ///< of the forces along X: what is left over [N]
    double       yaw_missed     = 0; ///< of the moments about the vertical [N m]
  };

  /// What presses a wheel and drives it: the pitch rate of its axle over the velocity [1/m]; where that is no
  /// number it turns by itself, as its scene drives it, or with a torque [N m], which gives the force along
  /// the wheelset over the rolling radius.
  WheelRailLoad
  load_of_wheel(const WheelOnAxle &wheel, double rate, const std::optional<double> &torque);

  /// Solves a wheel that turns by itself. Nothing without load.
  std::optional<WheelRailSolution>
  solve_alone(const WheelOnAxle &wheel, const std::optional<double> &torque);

  /// Half the distance of the first contact points of both wheels [m].
  double
  half_base(const SceneGeometry &right, const SceneGeometry &left);

  /// Solves both wheels (solve_axle(), or one by one with Wheelset/Axle = independent), each with the scene
  /// of its own, with half-spaces or the true bodies; a given torque of the axle [N m] takes the place of
  /// what drives the scenes. Loads follow from the curve (curve_loads()).
  ///
  /// With Wheelset/Pose = equilibrium lateral shift and yaw are found such that
  ///
  ///   Y_right + Y_left - c_y (y - y0) = (P / g) a,   M_z - c_psi (psi - psi0) = 0,
  ///
  /// with the forces and the moment of the contacts on the wheelset, the springs of Lateral stiffness and Yaw
  /// stiffness, which are at rest at the Lateral shift and Yaw of the scene, and the force that the curve
  /// asks for. The search starts where the rolling radii roll round the curve, with half-spaces, and
  /// ends where less than 1e-4 of the load is left over, or no less than 1e-3 can be. Where none is found,
  /// the last pose is returned, and its solutions say so. Throws InputError where the profiles do not touch.
  WheelsetSolution
  solve_wheelset(const Scene                 &right,
                 const Scene                 &left,
                 const WheelsetProfiles      &profiles,
                 const std::optional<double> &torque,
                 unsigned int                 threads = 1);

  /// The scene of one wheel alone in the pose, under the load and with the turning rate that were found, on
  /// straight track: its creepage counts against the rail as it comes towards it in the curve.
  Scene
  single_wheel(const WheelsetSolution &wheelset, bool left);
} // namespace wheelrail
