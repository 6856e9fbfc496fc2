#pragma once

#include <wheelrail/run/simulation.h>

namespace wheelrail
{
  /// What `run` does with a scene: one wheel (run_simulation()), or several one after the other
  /// (run_passages()). Collective; returns and throws as these.
  int
  run_scene(const Scene &scene, const SceneGeometry &geometry, const RunOptions &options);
} // namespace wheelrail
