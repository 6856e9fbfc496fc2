#include <wheelrail/geometry/running_surfaces.h>

#include <algorithm>
#include <cmath>

namespace wheelrail
{
  HeightTable::HeightTable(const FrameProfile &profile,
                           const double        s0,
                           const double        s1,
                           const double        spacing)
    : begin_(s0)
  {
    const int n = std::max(1, static_cast<int>(std::ceil((s1 - s0) / spacing)));
    spacing_    = (s1 - s0) / n;
    for (int k = 0; k <= n; ++k)
      {
        const auto value = profile.at(s0 + k * spacing_);
        height_.push_back(value.n);
        slope_.push_back(value.slope);
      }
  }


  FrameProfile::Value
  HeightTable::at(const double s) const
  {
    const double x = (s - begin_) / spacing_;
    const int    k = std::clamp(static_cast<int>(std::floor(x)), 0, static_cast<int>(height_.size()) - 2);
    const double t = x - k;
    const double d = height_[k + 1] - height_[k], m0 = spacing_ * slope_[k], m1 = spacing_ * slope_[k + 1];
    // h0 + m0 t + (3 d - 2 m0 - m1) t^2 + (m0 + m1 - 2 d) t^3
    const double b = 3 * d - 2 * m0 - m1, c = m0 + m1 - 2 * d;
    return {height_[k] + t * (m0 + t * (b + t * c)), (m0 + t * (2 * b + 3 * t * c)) / spacing_};
  }


  RunningSurfaces::Place
  RunningSurfaces::rail_place(const Vector3 &X) const
  {
    const Point2 q = frame.to_frame({X[0], X[1]});
    return {q.x, q.y, X[2]};
  }


  RunningSurfaces::Place
  RunningSurfaces::wheel_place(const Vector3 &X) const
  {
    const Point2 q = tread_frame.to_frame(pose.on_section(X));
    return {q.x, q.y, rolling_radius * pose.angle(X)};
  }


  double
  RunningSurfaces::wheel_offset(const Vector3 &X) const
  {
    const Point2 q     = tread_frame.to_frame(pose.on_section(X));
    const auto   value = tread.at(q.x);
    return (q.y - value.n) / std::sqrt(1 + value.slope * value.slope);
  }


  double
  RunningSurfaces::rail_offset(const Vector3 &X) const
  {
    const Point2 q     = frame.to_frame({X[0], X[1]});
    const auto   value = rail.at(q.x);
    return (value.n - q.y) / std::sqrt(1 + value.slope * value.slope);
  }


  double
  half_length_bound(const double approach, const double rolling_radius)
  {
    return std::sqrt(2 * rolling_radius * approach);
  }


  Vector3
  RunningSurfaces::rolling(const double s, const double z) const
  {
    const Point2 place = frame.to_track({s, wheel.at(s).n});
    return pose.rolling({place.x, place.y, z});
  }
} // namespace wheelrail
