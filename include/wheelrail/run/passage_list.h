#pragma once

#include <wheelrail/scene/scene.h>

#include <vector>

namespace wheelrail
{
  /// The wheels of one round over the rail: the scene itself, or a scene for each row of Run/Passage list,
  /// all with fine cells for the largest of their loads (Mesh/Planned load). Throws InputError for a list
  /// that cannot be read.
  std::vector<Scene>
  passage_scenes(const Scene &scene);
} // namespace wheelrail
