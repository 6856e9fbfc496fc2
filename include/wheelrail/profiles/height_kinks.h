#pragma once

#include <wheelrail/geometry/curve.h>
#include <wheelrail/profiles/height_grid.h>

#include <vector>

namespace wheelrail
{
  /// Where the slope of measured heights jumps along, by what it changes between their places: over a step
  /// twice as large a kink has the same jump, a jump of the curvature twice and a smooth shape eight times
  /// the jump. What noise may make is none. Beyond the ends their heights hold, or those of a wheel that is
  /// measured all around (`circumference`, else 0) [m].
  std::vector<Kink>
  kinks_of(const HeightGrid &grid, double circumference);
} // namespace wheelrail
