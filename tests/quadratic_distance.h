#pragma once

#include <wheelrail/halfspace/problem.h>

#include <vector>

namespace test
{
  /// Undeformed distance of paraboloids (Hertz 1882), x^2/(2 rx) + y^2/(2 ry) [m]; rx, ry: relative radii of
  /// curvature, 1/r = 1/r1 + 1/r2 [m].
  inline std::vector<double>
  quadratic_distance(const wheelrail::HalfspaceGrid &grid, const double rx, const double ry)
  {
    return wheelrail::sampled_distance(
      grid, [&](const double x, const double y) { return x * x / (2 * rx) + y * y / (2 * ry); });
  }
} // namespace test
