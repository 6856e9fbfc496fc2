#include <wheelrail/damage/machining.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>

namespace wheelrail
{
  namespace
  {
    constexpr double deepest = 15e-3; ///< that a machine takes off [m]

    /// Height of the outermost place of points at x: the highest of a rail, the lowest of a wheel.
    std::optional<double>
    height_at(const std::vector<Point2> &points, const double x, const double out)
    {
      std::optional<double> found;
      for (std::size_t k = 1; k < points.size(); ++k)
        {
          const Point2 &a = points[k - 1], &b = points[k];
          if ((a.x - x) * (b.x - x) > 0 || a.x == b.x)
            continue;
          const double y = a.y + (b.y - a.y) * (x - a.x) / (b.x - a.x);
          if (!found || out * y > out * *found)
            found = y;
        }
      return found;
    }

    /// The points with straight ends, so that they end behind those of a shape that is moved against them.
    std::vector<Point2>
    with_longer_ends(std::vector<Point2> points)
    {
      const auto beyond = [](const Point2 &end, const Point2 &before) {
        return end + deepest / norm(end - before) * (end - before);
      };
      const Point2 first = beyond(points[0], points[1]),
                   last  = beyond(points.back(), points[points.size() - 2]);
      points.insert(points.begin(), first);
      points.push_back(last);
      return points;
    }

    /// Least distance from p along the unit vector n to the points, below `deepest`; 0 where there is none.
    double
    distance_to(const std::vector<Point2> &points, const Point2 &p, const Point2 &n)
    {
      double distance = deepest;
      for (std::size_t k = 1; k < points.size(); ++k)
        {
          const Point2 side = points[k] - points[k - 1], from = points[k - 1] - p;
          const double turn = cross(n, side);
          if (turn == 0)
            continue;
          const double along = cross(from, side) / turn, share = cross(from, n) / turn;
          if (share >= 0 && share <= 1 && along >= 0)
            distance = std::min(distance, along);
        }
      return distance < deepest ? distance : 0;
    }
  } // namespace


  Machining
  machining(const WornShape &shape, const std::vector<Point2> &target, const double steepest)
  {
    const double out = shape.steel_on_left ? 1 : -1; // the side of the air, upwards of a rail
    Machining    work;
    double       beyond = -std::numeric_limits<double>::infinity();
    for (std::size_t k = 1; k + 1 < target.size(); ++k)
      {
        const Point2 chord = target[k + 1] - target[k - 1];
        if (std::abs(chord.y) > std::tan(steepest) * std::abs(chord.x))
          continue;
        if (const auto height = height_at(shape.points, target[k].x, out))
          beyond = std::max(beyond, out * (target[k].y - *height));
      }
    work.shift                = std::isfinite(beyond) ? beyond : 0;
    std::vector<Point2> moved = with_longer_ends(target);
    for (Point2 &p : moved)
      p.y -= out * work.shift;
    const std::vector<double> cells = cell_lengths(arc_of(shape.points));
    work.sections.assign(cells.size(), 0);
    for (std::size_t k = 0; k < cells.size(); ++k)
      {
        const double depth = distance_to(moved, shape.points[k], into_steel(shape, k));
        work.sections[k]   = depth * cells[k];
        work.depth         = std::max(work.depth, depth);
      }
    WornShape after = shape;
    take_off(work.sections, after);
    work.section = section_between(shape.points, after.points);
    return work;
  }
} // namespace wheelrail
