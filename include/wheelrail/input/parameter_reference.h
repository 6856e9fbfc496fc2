#pragma once

#include <string>

namespace wheelrail
{
  struct Entry;

  /// What an entry accepts as its table has it: ranges without the kind of value, which the units show
  /// (`100 mm to 5 m` for `a length from 100 mm to 5 m`).
  std::string
  printed_range(const Entry &entry);

  /// The table of all entries in Markdown, section by section: name, default, what is accepted,
  /// meaning; and the units that each kind of value takes. doc/manual/parameters.md is this text.
  std::string
  parameter_reference();
} // namespace wheelrail
