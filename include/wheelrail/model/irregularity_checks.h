#pragma once

#include <wheelrail/input/cross_checks.h>
#include <wheelrail/model/expected_patch.h>
#include <wheelrail/model/scene_geometry.h>

namespace wheelrail
{
  /// Adds what forbids a run over the irregularities of a scene, whose profiles are in touch: cells
  /// that cannot follow them, waves shorter than the patch, a start on them, places that the wheel never
  /// reaches.
  void
  check_irregular_run(const Scene         &scene,
                      const SceneGeometry &geometry,
                      const ExpectedPatch &patch,
                      Findings            &found);
} // namespace wheelrail
