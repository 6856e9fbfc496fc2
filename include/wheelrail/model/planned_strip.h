#pragma once

#include <wheelrail/mesh/sweep_plan.h>
#include <wheelrail/model/scene_geometry.h>
#include <wheelrail/scene/scene.h>

#include <vector>

namespace wheelrail
{
  /// Where Mesh/Planned strip places the fine cells.
  struct PlannedStrip
  {
    /// Wheel and rail where they touch, but with the frame of the surfaces at the middle of the strip on the
    /// rail and the nominal radius as the rolling one: what a rail is divided by depends on no wheel.
    TouchingProfiles profiles;
    Range            s; ///< the strip in that frame [m]
  };

  /// For a scene whose entries fit together (cross_checks()). Throws InputError where the rail head ends
  /// before the strip does.
  PlannedStrip
  plan_strip(const Scene &scene, const SceneGeometry &geometry);

  /// The two places on the rail's section, ascending, between which the scene wants fine cells: its patch at
  /// `load` [N] and Mesh/Fine margin beside it [m].
  std::vector<double>
  strip_of_patch(const Scene &scene, const SceneGeometry &geometry, double load);

  /// Widens the fine cells of a plan, `sizes.across`, to where wheel and rail meet on the irregularities of
  /// the path: the undeformed surfaces are brought together at places all along them, deeper than at rest by
  /// what an impact may press them.
  void
  plan_for_irregularities(const SceneGeometry &geometry, SweepSizes &sizes);
} // namespace wheelrail
