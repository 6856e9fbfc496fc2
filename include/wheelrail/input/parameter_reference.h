#pragma once

#include <string>

namespace wheelrail
{
  /// The table of all entries in Markdown, section by section: name, default, what is accepted,
  /// meaning; and the units that each kind of value takes. doc/manual/parameters.md is this text.
  std::string
  parameter_reference();
} // namespace wheelrail
