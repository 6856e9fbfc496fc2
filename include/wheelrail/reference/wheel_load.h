#pragma once

#include <wheelrail/model/scene_geometry.h>
#include <wheelrail/scene/scene.h>

namespace wheelrail
{
  /// Wheelset/Wheel load, or the weight of sprung mass, axle and wheel [N]; the wheel's mass is that of the
  /// section a run would mesh, turned around the axle, times its density. Where no run is possible, since the
  /// contact lies on the flange, the section is the one of the centred wheelset. Throws InputError when there
  /// is none either.
  double
  static_wheel_load(const Scene &scene, const SceneGeometry &geometry);
} // namespace wheelrail
