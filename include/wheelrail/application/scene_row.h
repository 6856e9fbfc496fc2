#pragma once

#include <wheelrail/scene/scene.h>

#include <string>

namespace wheelrail
{
  /// The scene at one row of a vehicle simulation: `place` is the file and the number of the row, from 1, as
  /// "prm/s_curve.csv:25". A torque becomes the traction coefficient that it has at the rolling radius and
  /// the wheel load. Throws InputError that names --row, file and number.
  Scene
  scene_of_row(const Scene &scene, const std::string &place);

  /// The scene at the place where it starts to follow its Wheelset/Motion, or the scene itself when it
  /// follows none; a torque likewise. Throws InputError as SceneMotion does.
  Scene
  scene_at_start(const Scene &scene);
} // namespace wheelrail
