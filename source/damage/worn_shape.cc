#include <wheelrail/damage/worn_shape.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace wheelrail
{
  WornShape
  worn_shape(const Curve &curve, const double lowest, const double spacing, const bool steel_on_left)
  {
    WornShape    shape;
    const double length = curve.length(0, curve.parameter_end());
    const auto   pieces = static_cast<std::size_t>(std::ceil(length / spacing));
    double       t      = 0;
    for (std::size_t k = 0; k <= pieces; ++k)
      {
        if (const Point2 p = curve.at(t).position; p.y >= lowest)
          shape.points.push_back(p);
        t = curve.advance(t, length / static_cast<double>(pieces));
      }
    shape.depth.assign(shape.points.size(), 0);
    shape.damage.assign(shape.points.size(), 0);
    shape.cracks.assign(shape.points.size(), 0);
    shape.steel_on_left = steel_on_left;
    return shape;
  }


  std::vector<double>
  arc_of(const std::vector<Point2> &points)
  {
    std::vector<double> arc = {0};
    for (std::size_t k = 1; k < points.size(); ++k)
      arc.push_back(arc.back() + norm(points[k] - points[k - 1]));
    return arc;
  }


  double
  arc_next_to(const std::vector<Point2> &points, const std::vector<double> &arc, const Point2 &p)
  {
    double least = std::numeric_limits<double>::infinity(), nearest = 0;
    for (std::size_t k = 1; k < points.size(); ++k)
      {
        const Point2 step  = points[k] - points[k - 1];
        const double share = std::clamp(dot(p - points[k - 1], step) / dot(step, step), 0., 1.);
        const double apart = norm(p - points[k - 1] - share * step);
        if (apart < least)
          {
            least   = apart;
            nearest = arc[k - 1] + share * (arc[k] - arc[k - 1]);
          }
      }
    return nearest;
  }


  std::vector<double>
  cell_lengths(const std::vector<double> &arc)
  {
    std::vector<double> cells(arc.size());
    for (std::size_t k = 0; k < arc.size(); ++k)
      cells[k] = 0.5 * (arc[std::min(k + 1, arc.size() - 1)] - arc[k > 0 ? k - 1 : 0]);
    return cells;
  }


  void
  spread_section(const std::vector<double> &cells,
                 const double               from,
                 const double               to,
                 const double               section,
                 std::vector<double>       &sections)
  {
    const double low = std::min(from, to), high = std::max(from, to);
    double       begin = 0, left = section;
    for (std::size_t k = 0; k < cells.size() && high > low; ++k)
      {
        const double end     = begin + cells[k];
        const double overlap = std::max(0., std::min(end, high) - std::max(begin, low));
        sections[k] += section * overlap / (high - low);
        left -= section * overlap / (high - low);
        begin = end;
      }
    // the ends of a profile, or a row seen edge on
    std::size_t k = 0;
    for (double end = cells[0]; k + 1 < cells.size() && end < low; end += cells[k])
      ++k;
    sections[k] += left;
  }


  std::vector<double>
  smoothed_sections(const std::vector<double> &arc, const std::vector<double> &sections, const double cut_off)
  {
    // exp(-2 (pi sigma / cut_off)^2) = 1/2
    const double              sigma = cut_off * std::sqrt(0.5 * std::log(2.)) / M_PI;
    const std::vector<double> cells = cell_lengths(arc);
    std::vector<double>       smooth(sections.size(), 0), weights(sections.size());
    for (std::size_t k = 0; k < sections.size(); ++k)
      {
        if (sections[k] == 0)
          continue;
        double sum = 0;
        for (std::size_t m = 0; m < sections.size(); ++m)
          {
            const double apart = (arc[m] - arc[k]) / sigma;
            weights[m]         = std::abs(apart) < 5 ? cells[m] * std::exp(-0.5 * apart * apart) : 0;
            sum += weights[m];
          }
        for (std::size_t m = 0; m < sections.size(); ++m)
          smooth[m] += sections[k] * weights[m] / sum;
      }
    return smooth;
  }


  Point2
  into_steel(const WornShape &shape, const std::size_t point)
  {
    const auto  &points = shape.points;
    const Point2 chord  = points[std::min(point + 1, points.size() - 1)] - points[point > 0 ? point - 1 : 0];
    const double side   = (shape.steel_on_left ? 1 : -1) / norm(chord);
    return {-side * chord.y, side * chord.x};
  }


  void
  take_off(const std::vector<double> &sections, WornShape &shape)
  {
    const WornShape           before = shape;
    const std::vector<double> cells  = cell_lengths(arc_of(before.points));
    for (std::size_t k = 0; k < cells.size(); ++k)
      {
        const double depth = sections[k] / cells[k];
        shape.points[k]    = before.points[k] + depth * into_steel(before, k);
        shape.depth[k] += depth;
      }
  }


  double
  section_between(const std::vector<Point2> &before, const std::vector<Point2> &now)
  {
    // the outline along one and back along the other
    double     twice = 0;
    const auto add   = [&](const Point2 &a, const Point2 &b) { twice += cross(a, b); };
    for (std::size_t k = 1; k < before.size(); ++k)
      {
        add(before[k - 1], before[k]);
        add(now[k], now[k - 1]);
      }
    add(before.back(), now.back());
    add(now.front(), before.front());
    return std::abs(0.5 * twice);
  }
} // namespace wheelrail
