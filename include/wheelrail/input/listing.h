#pragma once

#include <wheelrail/scene/scene.h>

#include <string>

namespace wheelrail
{
  /// How parameters are printed.
  enum class ParameterStyle
  {
    prm,  ///< a parameter file, each entry with its meaning, what is accepted, and its default
    json, ///< as deal.II's ParameterHandler writes and reads JSON
    xml   ///< as it and deal.II's parameter GUI write and read XML
  };

  /// All entries with the values of `scene`. In the style prm read_scene() accepts them.
  std::string
  print_parameters(const Scene &scene, ParameterStyle style = ParameterStyle::prm);

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
