#pragma once

#include <wheelrail/input/entry_kinds.h>

#include <vector>

namespace wheelrail
{
  /// The entries of the section Half-space, in the order of the listing.
  std::vector<Entry>
  halfspace_entries();
} // namespace wheelrail
