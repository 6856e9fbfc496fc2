#include <wheelrail/sampling/patch_edge.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace wheelrail
{
  namespace
  {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();

    struct Point
    {
      double x, y; ///< along, lateral
    };

    /// The nodes of the grid with bounds; i along the track, j lateral.
    struct Grid
    {
      const PatchFields &patch;
      double             threshold; ///< pressure above which a node counts as loaded [Pa]

      bool
      has(const int i, const int j) const
      {
        return i >= 0 && j >= 0 && i < int(patch.n_along) && j < int(patch.n_lateral);
      }
      std::size_t
      index(const int i, const int j) const
      {
        return std::size_t(i) * patch.n_lateral + j;
      }
      bool
      loaded(const int i, const int j) const
      {
        return has(i, j) && patch.pressure[index(i, j)] > threshold;
      }
      Point
      at(const int i, const int j) const
      {
        return {patch.along[index(i, j)], patch.lateral[index(i, j)]};
      }
      double
      distance(const int i, const int j, const int k, const int l) const
      {
        return std::hypot(at(i, j).x - at(k, l).x, at(i, j).y - at(k, l).y);
      }
    };

    /// Distance from the loaded node (i, j) in direction (di, dj) at which p^2 vanishes: parabola through
    /// the node and the two behind it, a straight line where there is only one or where the parabola is
    /// not concave; NaN where the pressure does not fall towards the edge.
    double
    from_pressure(const Grid &grid, const int i, const int j, const int di, const int dj)
    {
      const auto square = [&](const int n) {
        const double p = grid.patch.pressure[grid.index(i - n * di, j - n * dj)];
        return p * p;
      };
      if (!grid.loaded(i - di, j - dj))
        return nan;
      const double h1 = grid.distance(i, j, i - di, j - dj), q0 = square(0), q1 = square(1);
      if (!(q1 > q0))
        return nan;
      const double slope01 = (q0 - q1) / h1; // outwards, negative
      double       slope = slope01, curvature = 0;
      if (grid.loaded(i - 2 * di, j - 2 * dj))
        {
          const double h2      = grid.distance(i - di, j - dj, i - 2 * di, j - 2 * dj);
          const double slope12 = (q1 - square(2)) / h2;
          curvature            = std::min(0., (slope01 - slope12) / (h1 + h2));
          slope                = slope01 + curvature * h1;
        }
      // root of q0 + slope t + curvature t^2 in the form that has no cancellation
      return -2 * q0 / (slope - std::sqrt(slope * slope - 4 * curvature * q0));
    }

    /// The same distance from the open side, where gap^(2/3) is extrapolated linearly to zero; NaN without a
    /// second open node or when the gap does not grow outwards.
    double
    from_gap(const Grid &grid, const int i, const int j, const int di, const int dj)
    {
      const int i1 = i + di, j1 = j + dj, i2 = i1 + di, j2 = j1 + dj;
      if (!grid.has(i2, j2) || grid.loaded(i2, j2))
        return nan;
      const auto power = [&](const int k, const int l) {
        return std::cbrt(std::pow(std::max(0., grid.patch.gap[grid.index(k, l)]), 2));
      };
      const double g1 = power(i1, j1), g2 = power(i2, j2);
      if (!(std::isfinite(g2) && g2 > g1))
        return nan;
      return grid.distance(i, j, i1, j1) - g1 / (g2 - g1) * grid.distance(i1, j1, i2, j2);
    }

    /// Edge point between the loaded node (i, j) and its open neighbour.
    Point
    edge_point(const Grid &grid, const int i, const int j, const int di, const int dj)
    {
      const double h       = grid.distance(i, j, i + di, j + dj);
      const double inside  = std::clamp(from_pressure(grid, i, j, di, dj) / h, 0., 1.);
      const double outside = std::clamp(from_gap(grid, i, j, di, dj) / h, 0., 1.);
      double       t       = 0.5 * (inside + outside);
      if (std::isnan(inside) && std::isnan(outside))
        t = 0.5; // a lone node without neighbours to judge by
      else if (std::isnan(inside))
        t = outside;
      else if (std::isnan(outside))
        t = inside;
      const Point a = grid.at(i, j), b = grid.at(i + di, j + dj);
      return {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)};
    }

    /// Twice the signed area of a polygon.
    double
    twice_area(const std::vector<Point> &polygon)
    {
      double sum = 0;
      for (std::size_t k = 0; k < polygon.size(); ++k)
        {
          const Point &a = polygon[k], &b = polygon[(k + 1) % polygon.size()];
          sum += a.x * b.y - a.y * b.x;
        }
      return sum;
    }

    /// Adds the loaded part of the cell with the lowest corner (i, j) and its pieces of the edge. Loaded
    /// corners that are only diagonal neighbours count as separate.
    void
    add_cell(const Grid &grid, const int i, const int j, double &area, PatchEdge &edge)
    {
      const int corner[5][2] = {{i, j}, {i + 1, j}, {i + 1, j + 1}, {i, j + 1}, {i, j}};

      std::vector<Point> polygon;
      std::vector<Point> ends;
      int                n_loaded = 0;
      for (int k = 0; k < 4; ++k)
        {
          const int *a = corner[k], *b = corner[k + 1];
          const bool la = grid.loaded(a[0], a[1]), lb = grid.loaded(b[0], b[1]);
          n_loaded += la;
          if (la)
            polygon.push_back(grid.at(a[0], a[1]));
          if (la != lb)
            {
              const int  *from = la ? a : b, *to = la ? b : a;
              const Point end = edge_point(grid, from[0], from[1], to[0] - from[0], to[1] - from[1]);
              polygon.push_back(end);
              ends.push_back(end);
            }
        }

      const auto add_chord = [&](const Point &a, const Point &b) {
        edge.chords.push_back({{a.x, a.y, b.x, b.y}});
      };
      if (n_loaded == 2 && ends.size() == 4)
        {
          // one triangle around each loaded corner
          const bool  first = grid.loaded(i, j);
          const Point c[2]  = {first ? grid.at(i, j) : grid.at(i + 1, j),
                              first ? grid.at(i + 1, j + 1) : grid.at(i, j + 1)};
          const unsigned int e[4] = {first ? 3u : 0u, first ? 0u : 1u, first ? 1u : 2u, first ? 2u : 3u};
          for (int t = 0; t < 2; ++t)
            {
              area += 0.5 * std::abs(twice_area({c[t], ends[e[2 * t]], ends[e[2 * t + 1]]}));
              add_chord(ends[e[2 * t]], ends[e[2 * t + 1]]);
            }
          return;
        }
      area += 0.5 * std::abs(twice_area(polygon));
      if (ends.size() == 2)
        add_chord(ends[0], ends[1]);
    }

    /// Separate patches minus holes: Euler's characteristic of the loaded nodes (nodes - links + cells).
    int
    euler_characteristic(const Grid &grid)
    {
      int sum = 0;
      for (int i = 0; i < int(grid.patch.n_along); ++i)
        for (int j = 0; j < int(grid.patch.n_lateral); ++j)
          if (grid.loaded(i, j))
            {
              const bool right = grid.loaded(i + 1, j), up = grid.loaded(i, j + 1);
              sum += 1 - right - up + (right && up && grid.loaded(i + 1, j + 1));
            }
      return sum;
    }

    /// Area between the chords and the curved edge. A chord of length L that turns by phi cuts off
    /// L^2 phi / 12 (circle segment, small angles), and a closed line turns by 2 pi in all; with the mean
    /// of L^2 over the line that needs no curvature of single, noisy points.
    double
    segments_area(const PatchEdge &edge)
    {
      double sum1 = 0, sum3 = 0;
      for (const auto &c : edge.chords)
        {
          const double length = std::hypot(c[2] - c[0], c[3] - c[1]);
          sum1 += length;
          sum3 += length * length * length;
        }
      return sum1 > 0 ? M_PI / 6 * int(edge.n_patches) * sum3 / sum1 : 0;
    }

    /// Largest value of the parabola through the largest of `values` and its neighbours (equal distances);
    /// NaN marks grid lines that do not meet the patch.
    double
    smooth_maximum(const std::vector<double> &values)
    {
      std::size_t k    = 0;
      double      best = -std::numeric_limits<double>::max();
      for (std::size_t n = 0; n < values.size(); ++n)
        if (values[n] > best)
          {
            best = values[n];
            k    = n;
          }
      if (k == 0 || k + 1 >= values.size())
        return best;
      const double slope = (values[k + 1] - values[k - 1]) / 2;
      const double bend  = values[k + 1] - 2 * values[k] + values[k - 1];
      return bend < 0 ? best - slope * slope / (2 * bend) : best; // also when a neighbour is NaN
    }

    /// Extent of the patch in direction 0 (along) or 1 (lateral), from the outermost edge points of the
    /// grid lines in that direction.
    void
    find_extent(const Grid &grid, const int direction, double &low, double &high)
    {
      const int           di = direction == 0, dj = direction == 1;
      const int           n = direction == 0 ? grid.patch.n_along : grid.patch.n_lateral;
      const int           m = direction == 0 ? grid.patch.n_lateral : grid.patch.n_along;
      std::vector<double> highest(m, nan), lowest_negated(m, nan);
      const auto          coordinate = [&](const Point &p) { return direction == 0 ? p.x : p.y; };

      for (int line = 0; line < m; ++line)
        for (int k = 0; k < n; ++k)
          {
            const int i = di ? k : line, j = dj ? k : line;
            if (!grid.loaded(i, j))
              continue;
            for (const int sign : {-1, 1})
              {
                Point end = grid.at(i, j);
                if (grid.loaded(i + sign * di, j + sign * dj))
                  continue;
                if (grid.has(i + sign * di, j + sign * dj))
                  end = edge_point(grid, i, j, sign * di, sign * dj);
                highest[line]        = std::fmax(highest[line], coordinate(end));
                lowest_negated[line] = std::fmax(lowest_negated[line], -coordinate(end));
              }
          }
      high = smooth_maximum(highest);
      low  = -smooth_maximum(lowest_negated);
    }
  } // namespace

  PatchEdge
  find_patch_edge(const PatchFields &patch)
  {
    PatchEdge    edge;
    const double peak =
      patch.pressure.empty() ? 0. : *std::max_element(patch.pressure.begin(), patch.pressure.end());
    if (!(peak > 0))
      return edge;

    const Grid grid{patch, 1e-3 * peak}; // loaded: see measure_patch()
    for (int i = 0; i < int(patch.n_along); ++i)
      for (int j = 0; j < int(patch.n_lateral); ++j)
        if (grid.loaded(i, j))
          {
            ++edge.n_loaded;
            if (i == 0 || j == 0 || i + 1 == int(patch.n_along) || j + 1 == int(patch.n_lateral))
              edge.touches_border = true;
          }
    edge.n_patches = static_cast<unsigned int>(std::max(0, euler_characteristic(grid)));

    for (int i = 0; i + 1 < int(patch.n_along); ++i)
      for (int j = 0; j + 1 < int(patch.n_lateral); ++j)
        add_cell(grid, i, j, edge.area, edge);
    edge.area += segments_area(edge);

    find_extent(grid, 0, edge.along_min, edge.along_max);
    find_extent(grid, 1, edge.lateral_min, edge.lateral_max);
    return edge;
  }
} // namespace wheelrail
