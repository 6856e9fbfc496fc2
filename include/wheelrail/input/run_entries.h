#pragma once

#include <wheelrail/input/entry_kinds.h>

#include <vector>

namespace wheelrail
{
  /// The entries of how a scene is computed: sections Mesh, Run, Output and Half-space, in the order of
  /// the listing.
  std::vector<Entry>
  run_entries();
} // namespace wheelrail
