#pragma once

#include <wheelrail/model/scene_geometry.h>
#include <wheelrail/statics/start_tractions.h>

namespace wheelrail
{
  /// What this wheel and this rail deflect across the track beyond half-spaces under the tractions of a
  /// static start, by their tables (make_body_tables()). What they deflect along it is left out: without it
  /// starts have a creepage 0.5 % too large, with it 1 % (doc/theory/rolling.md). The result keeps the
  /// influences of the grids that it was last asked for; scene and geometry must outlive it. Without sections
  /// that can be meshed it is empty. Not for several threads at once.
  BeyondHalfspaces
  bodies_of_start(const Scene &scene, const SceneGeometry &geometry);
} // namespace wheelrail
