#include <wheelrail/sections/section_column.h>

#include <algorithm>
#include <utility>

namespace wheelrail
{
  SectionColumn::SectionColumn(const std::size_t first, std::vector<Point2> points, std::vector<Point2> along)
    : first_(first)
    , points_(std::move(points))
    , along_(std::move(along))
  {
    std::vector<double> arcs, x, y;
    for (std::size_t k = 0; k < points_.size(); ++k)
      {
        arcs.push_back(k == 0 ? 0 : arcs.back() + norm(points_[k] - points_[k - 1]));
        x.push_back(points_[k].x);
        y.push_back(points_[k].y);
      }
    x_ = CubicSpline(arcs, std::move(x));
    y_ = CubicSpline(std::move(arcs), std::move(y));
  }


  SectionColumn::Point
  SectionColumn::at(const double s) const
  {
    const CubicSpline::Value x = x_.at(s), y = y_.at(s);
    const double             place = line(s) - static_cast<double>(first_);
    const std::size_t        k     = std::min(static_cast<std::size_t>(place), points_.size() - 2);
    const double             b     = place - static_cast<double>(k);
    return {{x.value, y.value}, {x.slope, y.slope}, (1 - b) * along_[k] + b * along_[k + 1]};
  }


  double
  SectionColumn::arc(const double line) const
  {
    const std::vector<double> &arcs = x_.places();
    const double               place =
      std::clamp(line - static_cast<double>(first_), 0., static_cast<double>(arcs.size() - 1));
    const std::size_t k = std::min(static_cast<std::size_t>(place), arcs.size() - 2);
    return arcs[k] + (place - static_cast<double>(k)) * (arcs[k + 1] - arcs[k]);
  }


  double
  SectionColumn::line(const double s) const
  {
    const std::vector<double> &arcs = x_.places();
    const std::size_t          k = std::upper_bound(arcs.begin() + 1, arcs.end() - 1, s) - arcs.begin() - 1;
    return static_cast<double>(first_ + k) + std::clamp((s - arcs[k]) / (arcs[k + 1] - arcs[k]), 0., 1.);
  }
} // namespace wheelrail
