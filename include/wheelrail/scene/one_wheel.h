#pragma once

#include <wheelrail/scene/scene.h>

#include <limits>

namespace wheelrail
{
  /// Takes the modelled wheel out of its wheelset and its curve: what a run can roll. Load, pose and drive
  /// stay as they are.
  inline void
  leave_wheelset(Scene &scene)
  {
    scene.both_wheels = scene.pose_balances = false;
    scene.track_radius = scene.cant = std::numeric_limits<double>::infinity();
    scene.left_wheel_profile        = scene.left_rail_profile =
      "as right"; // of the modelled wheel there are no others
  }
} // namespace wheelrail
