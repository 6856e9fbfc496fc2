#pragma once

#include <wheelrail/application/scene.h>

#include <string>
#include <vector>

namespace wheelrail
{
  /// What the values of a scene contradict among each other, one sentence each, starting with the
  /// entry to change: "Run/Averaging distance = 20 mm: ...". Empty when the scene can be computed.
  /// Ranges of single values are the business of the entries.
  std::vector<std::string>
  cross_checks(const Scene &scene);

  /// What can be computed but may not be meant, one sentence each, to be shown at the start of a run.
  std::vector<std::string>
  scene_notes(const Scene &scene);
} // namespace wheelrail
