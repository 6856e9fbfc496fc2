#pragma once

#include <wheelrail/halfspace/influence.h>

#include <utility>
#include <vector>

namespace wheelrail
{
  /// Distances from loaded to observed element, in elements: from the first to before the end.
  struct DistanceRange
  {
    int first_x = 0, end_x = 0, first_y = 0, end_y = 0;
  };

  /// Visits the distances of a range, rows of y one by one: visit(i, j, far_far, far_near, near_far,
  /// near_near) gets the distance along x and y, in elements, and what corner(x, y) [m] gave at the corners
  /// of the element there, those with more x and more y first. The observed one lies `ahead` further along x
  /// [m]. Neighbours share their corners: each is computed once.
  template <typename Corner, typename Visit>
  void
  sweep_corners(const HalfspaceGrid &grid,
                const DistanceRange &range,
                const double         ahead,
                const Corner        &corner,
                const Visit         &visit)
  {
    const int                               n = range.end_x - range.first_x;
    std::vector<decltype(corner(0.0, 0.0))> near(n + 1), far(n + 1); // corners with less and with more y
    const auto                              corners = [&](const int j, auto &row) {
      for (int i = 0; i <= n; ++i)
        row[i] = corner((range.first_x + i - 0.5) * grid.dx + ahead, (j - 0.5) * grid.dy);
    };
    corners(range.first_y, far);
    for (int j = range.first_y; j < range.end_y; ++j)
      {
        std::swap(near, far);
        corners(j + 1, far);
        for (int i = 0; i < n; ++i)
          visit(range.first_x + i, j, far[i + 1], near[i + 1], far[i], near[i]);
      }
  }
} // namespace wheelrail
