#pragma once

#include <wheelrail/geometry/profiles.h>

namespace wheelrail
{
  /// Flat-bottom rail 54E1, 159 mm high, 54.77 kg/m, new and nominal. Built from the drawing
  /// dimensions of EN 13674-1; all joints are tangent to round-off.
  RailProfile
  rail_54E1();

  /// Flat-bottom rail 60E1, 172 mm high, 60.21 kg/m, from the drawing dimensions of EN 13674-1.
  RailProfile
  rail_60E1();
} // namespace wheelrail
