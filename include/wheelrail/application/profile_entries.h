#pragma once

#include <wheelrail/application/entry_kinds.h>

#include <vector>

namespace wheelrail
{
  /// The entries of the subsection Profiles: names or files of wheel and rail, and how files are read.
  std::vector<Entry>
  profile_entries();
} // namespace wheelrail
