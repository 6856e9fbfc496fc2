#pragma once

#include <wheelrail/run/simulation.h>

#include <string>

namespace wheelrail
{
  /// Run/Passages wheels one after the other over the same rail: each is a run of its own in passage_001,
  /// passage_002,
  /// ... below the folder of the scene, from the second on over the rail that the one before has left. After
  /// each, passages.csv is written anew from the summaries of all. With options.resume finished passages are
  /// kept, and the first that is not goes on from its saved state. Collective; returns and throws as
  /// run_simulation().
  int
  run_passages(const Scene &scene, const SceneGeometry &geometry, const RunOptions &options);

  /// The table passages.csv of the first `n` passages below `folder`.
  std::string
  passage_table(const std::string &folder, unsigned int n);

  /// "FOLDER/passage_003".
  std::string
  passage_folder(const std::string &folder, unsigned int passage);
} // namespace wheelrail
