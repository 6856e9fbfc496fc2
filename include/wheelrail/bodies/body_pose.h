#pragma once

#include <wheelrail/sampling/pose.h>
#include <wheelrail/wheel/halfspace_case.h>

namespace wheelrail
{
  /// Where rail head and wheel rim turn and move to under the contact of the true bodies (solve_bodies()),
  /// that of the turning wheel included: rigid motion fitted to the displacements of their sections in the
  /// same places and the same slab as those of a run, by least squares over the area. Takes some tenths of a
  /// second. Throws as make_body_tables() does.
  ContactPose
  body_pose(const Scene &scene, const SceneGeometry &geometry, const WheelRailSolution &result);
} // namespace wheelrail
