#include <wheelrail/model/scene_geometry.h>
#include <wheelrail/sections/crossing_heights.h>
#include <wheelrail/sections/posed_wheel.h>

#include <algorithm>
#include <cmath>

namespace wheelrail
{
  std::optional<double>
  above_section(const PosedWheel &wheel, const Point2 &p, const TrackDimensions &track, const double height)
  {
    const Placement rail{{}, -std::atan(track.inclination)};
    const Point2    P = rail.to_track(p), up = rail.to_track({0, 1});
    return wheel.distance({P.x, P.y, 0}, {up.x, up.y, 0}, height);
  }


  WheelLine
  wheel_line(const Scene &scene, const WheelProfile &profile)
  {
    constexpr double steepest = 0.6, below = -30e-3;
    constexpr int    reach = 320;
    const PosedWheel wheel(profile, scene.track, wheelset_pose(scene));
    const auto       at = [&](const int i) {
      const auto distance = above_section(wheel, {i * crossing_spacing, below}, scene.track, 0);
      return distance ? below + *distance : HUGE_VAL;
    };
    const auto end = [&](const int step) {
      int i = 0;
      while (std::abs(i) < reach && std::abs(at(i + step) - at(i)) < steepest * crossing_spacing)
        i += step;
      return i;
    };
    WheelLine line;
    for (int i = end(-1); i <= end(1); ++i)
      {
        line.across.push_back(i * crossing_spacing);
        line.height.push_back(at(i));
      }
    return line;
  }


  std::vector<double>
  heights_of(const SectionColumn &column, const std::vector<double> &across)
  {
    constexpr double    steepest = 3;
    std::vector<double> height(across.size(), -HUGE_VAL);
    struct End
    {
      double x, y, slope;
    };
    const auto end = [&](const std::size_t k) {
      const SectionColumn::Point p = column.at(column.arc(static_cast<double>(column.first() + k)));
      return End{-p.position.x, p.position.y, -p.tangent.y / p.tangent.x};
    };
    for (std::size_t k = 1; k < column.points().size(); ++k)
      {
        End a = end(k - 1), b = end(k);
        if (a.x > b.x)
          std::swap(a, b);
        const double dx = b.x - a.x;
        if (!(std::abs(b.y - a.y) < steepest * dx && std::abs(a.slope) < steepest &&
              std::abs(b.slope) < steepest))
          continue;
        const auto first = std::lower_bound(across.begin(), across.end(), a.x) - across.begin();
        for (auto i = static_cast<std::size_t>(first); i < across.size() && across[i] <= b.x; ++i)
          {
            const double t = (across[i] - a.x) / dx, d = b.y - a.y; // cubic between two points
            height[i] = std::max(height[i],
                                 a.y + t * (a.slope * dx + t * (3 * d - (2 * a.slope + b.slope) * dx +
                                                                t * ((a.slope + b.slope) * dx - 2 * d))));
          }
      }
    for (std::size_t i = 1; i < height.size(); ++i)
      height[i] = std::max(height[i], height[i - 1] - crossing_spacing);
    for (std::size_t i = height.size() - 1; i > 0; --i)
      height[i - 1] = std::max(height[i - 1], height[i] - crossing_spacing);
    return height;
  }


  double
  width_of(const SectionColumn &column)
  {
    constexpr double depth = 5e-3;
    double           top = -HUGE_VAL, low = HUGE_VAL, high = -HUGE_VAL;
    for (const Point2 &p : column.points())
      top = std::max(top, p.y);
    for (const Point2 &p : column.points())
      if (p.y > top - depth)
        {
          low  = std::min(low, p.x);
          high = std::max(high, p.x);
        }
    return high - low;
  }
} // namespace wheelrail
