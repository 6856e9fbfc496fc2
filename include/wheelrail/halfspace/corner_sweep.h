#pragma once

#include <wheelrail/halfspace/influence.h>

#include <utility>
#include <vector>

namespace wheelrail
{
  /// Visits the distances from loaded to observed element, in the order of InfluenceProducts::kernel():
  /// visit(i, j, far_far, far_near, near_far, near_near) gets the column and the row, from 0 on, and what
  /// corner(x, y) [m] gave at the corners of the element there, those with more x and more y first. The
  /// observed one lies `ahead` further along x [m]. Neighbours share their corners: each is computed once.
  template <typename Corner, typename Visit>
  void
  sweep_corners(const HalfspaceGrid     &grid,
                const InfluenceProducts &products,
                const double             ahead,
                const Corner            &corner,
                const Visit             &visit)
  {
    const int                               nx = products.columns(), ny = products.rows();
    const int                               middle_x = nx / 2, middle_y = ny / 2;
    std::vector<decltype(corner(0.0, 0.0))> near(nx + 1), far(nx + 1); // corners with less and with more y
    const auto                              corners = [&](const int j, auto &row) {
      for (int i = 0; i <= nx; ++i)
        row[i] = corner((i - middle_x - 0.5) * grid.dx + ahead, (j - middle_y - 0.5) * grid.dy);
    };
    corners(0, far);
    for (int j = 0; j < ny; ++j)
      {
        std::swap(near, far);
        corners(j + 1, far);
        for (int i = 0; i < nx; ++i)
          visit(i, j, far[i + 1], near[i + 1], far[i], near[i]);
      }
  }
} // namespace wheelrail
