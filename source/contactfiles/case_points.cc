#include <wheelrail/base/errors.h>
#include <wheelrail/contactfiles/case_points.h>
#include <wheelrail/halfspace/subsurface_layers.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>

namespace wheelrail
{
  namespace
  {
    /// Indices from 1 on that ISUBS names along a direction: all of them, first, step and last, or a list.
    std::vector<int>
    indices(const ContactPoints &points, const int elements, const std::size_t direction)
    {
      const std::vector<int> &n = points.counts;
      std::vector<int>        list;
      switch (points.kind % 4)
        {
          case 1:
            for (int i = 1; i <= elements; ++i)
              list.push_back(i);
            break;
          case 2:
            for (int i = n[3 * direction]; i <= n[3 * direction + 2]; i += std::max(1, n[3 * direction + 1]))
              list.push_back(i);
            break;
          default:
            {
              const auto first = n.begin() + 2 + (direction == 1 ? n[0] : 0);
              list.assign(first, first + n[direction]);
            }
        }
      for (const int i : list)
        if (i < 1 || i > elements)
          throw InputError("points below the surface: the index " + std::to_string(i) +
                           " lies outside of the grid, which has 1 to " + std::to_string(elements));
      return list;
    }

    /// The elements, from 0 on, in whose centres places lie; none where one lies beside them.
    std::vector<std::size_t>
    centres(const std::vector<double> &places, const double first, const double step, const int elements)
    {
      std::vector<std::size_t> list;
      for (const double place : places)
        {
          const double k = (place - first) / step, whole = std::round(k);
          if (!(whole >= 0 && whole < elements && std::abs(k - whole) < 1e-6))
            return {};
          list.push_back(std::size_t(whole));
        }
      return list;
    }

    /// Eigenvalues of a symmetric tensor, falling (Smith 1961).
    std::array<double, 3>
    principal_stresses(const HalfspaceStress &s)
    {
      const double mean = (s.xx + s.yy + s.nn) / 3;
      const double a = s.xx - mean, b = s.yy - mean, c = s.nn - mean;
      const double size =
        std::sqrt((a * a + b * b + c * c + 2 * (s.xy * s.xy + s.xn * s.xn + s.yn * s.yn)) / 6);
      if (size == 0)
        return {{mean, mean, mean}};
      const double determinant =
        a * (b * c - s.yn * s.yn) - s.xy * (s.xy * c - s.yn * s.xn) + s.xn * (s.xy * s.yn - b * s.xn);
      const double angle = std::acos(std::clamp(determinant / (2 * size * size * size), -1., 1.)) / 3;
      const double third = 2 * M_PI / 3;
      const double first = mean + 2 * size * std::cos(angle),
                   last  = mean + 2 * size * std::cos(angle + third);
      return {{first, 3 * mean - first - last, last}};
    }
  } // namespace


  PointBlock
  point_block(const ContactPoints &points, const HalfspaceGrid &grid)
  {
    PointBlock block;
    for (const double z : points.z)
      block.z.push_back(millimetre * z);
    if (points.kind == 9)
      {
        for (const double x : points.x)
          block.x.push_back(millimetre * x);
        for (const double y : points.y)
          block.y.push_back(millimetre * y);
        return block;
      }
    for (const int i : indices(points, grid.mx, 0))
      block.x.push_back(grid.x(i - 1));
    for (const int j : indices(points, grid.my, 1))
      block.y.push_back(grid.y(j - 1));
    return block;
  }

  std::vector<PointStress>
  block_stresses(const PointBlock &block, const ContactMaterial &material, const HalfspaceSolution &solution)
  {
    std::vector<PointStress> result;
    for (const double x : block.x)
      for (const double y : block.y)
        for (const double z : block.z)
          result.push_back({x, y, z, {}, {}});
    const auto body = [&](const std::size_t index) {
      return HalfspaceBody{megapascal * material.shear[index], material.poisson[index]};
    };
    const auto columns         = centres(block.x, solution.grid.x0, solution.grid.dx, solution.grid.mx),
               rows            = centres(block.y, solution.grid.y0, solution.grid.dy, solution.grid.my);
    constexpr std::size_t many = 100; // from so many places on transforms cost less than sums
    if (block.x.size() * block.y.size() >= many && !columns.empty() && !rows.empty())
      {
        SubsurfaceLayers layers(solution, body(0), body(1));
        for (std::size_t k = 0; k < block.z.size(); ++k)
          {
            const LayerStresses layer    = layers.at(std::abs(block.z[k]));
            const auto         &stresses = block.z[k] < 0 ? layer.body2 : layer.body1;
            std::size_t         next     = k;
            for (const std::size_t i : columns)
              for (const std::size_t j : rows)
                {
                  result[next].stress = stresses[i + std::size_t(solution.grid.mx) * j];
                  next += block.z.size();
                }
          }
      }
    else
      for (const auto side : {HalfspaceSide::body1, HalfspaceSide::body2})
        {
          const std::size_t index  = side == HalfspaceSide::body1 ? 0 : 1;
          const auto        inside = [&](const PointStress &point) { return (point.z < 0) == (index == 1); };
          std::vector<SubsurfacePoint> points;
          for (const PointStress &point : result)
            if (inside(point))
              points.push_back({point.x, point.y, std::abs(point.z)});
          const auto  stresses = subsurface_stresses(solution, body(index), side, points);
          std::size_t next     = 0;
          for (PointStress &point : result)
            if (inside(point))
              point.stress = stresses[next++];
        }
    for (PointStress &point : result)
      point.principal = principal_stresses(point.stress);
    return result;
  }

  std::vector<std::vector<PointStress>>
  case_stresses(const ContactCase &one, const HalfspaceSolution &solution)
  {
    std::vector<std::vector<PointStress>> blocks;
    for (const ContactPoints &points : one.points)
      if (one.digits.subsurface > 0)
        blocks.push_back(block_stresses(point_block(points, solution.grid), one.material, solution));
    return blocks;
  }
} // namespace wheelrail
