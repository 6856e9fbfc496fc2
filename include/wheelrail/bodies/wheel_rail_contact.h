#pragma once

#include <wheelrail/wheel/halfspace_case.h>

namespace wheelrail
{
  /// Steady rolling of one wheel on its rail by what Half-space/Bodies names: the true bodies
  /// (solve_bodies()), without offsets, or half-spaces (solve_halfspaces()). `time` is set.
  WheelRailSolution
  solve_wheel_rail(const Scene          &scene,
                   const SceneGeometry  &geometry,
                   const WheelRailLoad  &load,
                   const SectionOffsets &offsets);
} // namespace wheelrail
