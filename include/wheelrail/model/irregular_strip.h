#pragma once

#include <wheelrail/mesh/sweep_plan.h>
#include <wheelrail/model/scene_geometry.h>

namespace wheelrail
{
  /// Widens the fine cells of a plan, `sizes.across`, to where wheel and rail meet on the irregularities of
  /// the path: the undeformed surfaces are brought together at places all along them, deeper than at rest by
  /// what an impact may press them.
  void
  plan_for_irregularities(const SceneGeometry &geometry, SweepSizes &sizes);
} // namespace wheelrail
