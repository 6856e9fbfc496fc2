#pragma once

#include <wheelrail/run/simulation.h>

namespace wheelrail
{
  /// What `run` does with a scene: one wheel (run_simulation()), or several one after the other
  /// (run_passages()). Collective; returns and throws as these.
  int
  run_scene(const Scene &scene, const SceneGeometry &geometry, const RunOptions &options);

  /// Wheels one after the other over the same rail, those of passage_scenes() Run/Passages times over, or
  /// until steady (trend_of()): each is a run of its own in passage_001, passage_002, ... below the folder of
  /// the scene, from the second on over the rail that the one before has left. After each, passages.csv and
  /// passages.h5 are written anew. With options.resume finished passages are kept, and the first that is not
  /// resumes from its saved state. Collective; returns and throws as run_simulation().
  int
  run_passages(const Scene &scene, const SceneGeometry &geometry, const RunOptions &options);
} // namespace wheelrail
