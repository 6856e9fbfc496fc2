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
} // namespace wheelrail
