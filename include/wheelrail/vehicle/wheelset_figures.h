#pragma once

#include <wheelrail/output/summary.h>
#include <wheelrail/vehicle/wheelset_contact.h>

#include <string>
#include <vector>

namespace wheelrail
{
  /// The keys of what both wheels do together, "axle_torque_Nm" and so on, in the order of tables.
  const std::vector<std::string> &
  axle_keys();

  /// Sets them. Forces along X count to the left, moments about the vertical turn the nose to the left. The
  /// limit is that of the sum of the lateral forces which shifts the track, k (10 kN + P / 3) with the load P
  /// of the axle (Prud'homme 1967).
  void
  set_axle_figures(const WheelsetSolution &wheelset, Summary &summary);

  /// Sets the rolling radius of a wheel at its first contact point.
  void
  set_wheel_figures(const WheelsetSolution &wheelset, bool left, Summary &summary);

  /// The doubt about a wheelset whose wheel the curve lifts.
  std::string
  lifted_by_curve(bool left);

  /// The summary of a wheelset: the figures of the axle, and those of each wheel behind "right_" and "left_";
  /// finished and trusted as the worse of both. A null wheel is lifted.
  Summary
  wheelset_summary(const Scene            &scene,
                   const WheelsetSolution &wheelset,
                   const Summary          *right,
                   const Summary          *left);
} // namespace wheelrail
