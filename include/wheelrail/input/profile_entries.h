#pragma once

#include <wheelrail/input/entry_kinds.h>

#include <vector>

namespace wheelrail
{
  /// A text that is one of `names` or means a file (is_file_name()); `file` says which files are accepted.
  Entry
  name_or_file_entry(const EntryHead                &head,
                     const std::vector<std::string> &names,
                     const std::string              &file,
                     const Field<std::string>       &place);

  /// The entries of the subsection Profiles: names or files of wheel and rail, and how files are read.
  std::vector<Entry>
  profile_entries();
} // namespace wheelrail
