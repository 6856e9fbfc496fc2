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

  /// Whether there is such a subsection; the empty name is the place outside all.
  bool
  section_exists(const std::string &section);

  /// What to say of a subsection that is not there: the nearest, or all.
  std::string
  unknown_section(const std::string &section);

  /// What to say of an entry that is not there, and of its value: what to write in the place of an axle load;
  /// the nearest ones, or all of its subsection.
  std::string
  unknown_entry(const std::string &section, const std::string &name, const std::string &value = "");

  /// Paths of at most three entries whose names resemble `name` the most, those of `section` first
  /// among equals; empty when nothing resembles it.
  std::vector<std::string>
  nearest_entries(const std::string &section, const std::string &name);

  /// "Section/Name = value" with the value of `scene` as in the listing; the entry must exist.
  std::string
  entry_text(const Scene &scene, const std::string &section, const std::string &name);

  /// The entry that says how far the wheel rolls at most, Run/Rolling distance or Run/Longest distance:
  /// "Run/Longest distance".
  std::string
  path_entry(const RunSettings &scene);
  /// The same with the distance: "Run/Longest distance = 60 mm".
  std::string
  path_text(const RunSettings &scene);
} // namespace wheelrail
