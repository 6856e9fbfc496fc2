#pragma once

#include <wheelrail/geometry/profiles.h>
#include <wheelrail/scene/scene.h>

namespace wheelrail
{
  /// Wheelset/Wheel load, or the weight of sprung mass, axle and wheel [N]; the wheel's mass is that of its
  /// outline turned around the axle, times its density. Throws InputError when the dimensions of the wheel
  /// contradict each other or its profile.
  double
  static_wheel_load(const Scene &scene, const WheelProfile &profile);
} // namespace wheelrail
