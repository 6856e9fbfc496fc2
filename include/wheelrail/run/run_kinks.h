#pragma once

#include <wheelrail/model/scene_geometry.h>
#include <wheelrail/output/summary.h>
#include <wheelrail/verdict/measures.h>

namespace wheelrail
{
  /// The middle of the stretch of the means on irregular surfaces [m].
  double
  middle_of_means(const Scene &scene, const Summary &run, const Measures &measures);

  /// Kinks of the surfaces under the patch where the means are taken, and where the largest pressure acts.
  void
  measure_kinks(const Scene &scene, const SceneGeometry &geometry, const Summary &run, Measures &measures);
} // namespace wheelrail
