#pragma once

#include <wheelrail/input/entry_kinds.h>

#include <string>
#include <vector>

namespace wheelrail
{
  /// The table of all entries, in the order of the listing. Reading, the listing of `parameters`,
  /// the manual and all messages come from it.
  const std::vector<Entry> &
  entries();

  /// The entry, or a null pointer.
  const Entry *
  find_entry(const std::string &section, const std::string &name);

  /// Names of the subsections in the order of the table, without the empty one.
  std::vector<std::string>
  section_names();

  /// Paths of at most three entries whose names resemble `name` the most, those of `section` first
  /// among equals; empty when nothing resembles it.
  std::vector<std::string>
  nearest_entries(const std::string &section, const std::string &name);

  /// "Section/Name = value" with the value of `scene` as in the listing; the entry must exist.
  std::string
  entry_text(const Scene &scene, const std::string &section, const std::string &name);
} // namespace wheelrail
