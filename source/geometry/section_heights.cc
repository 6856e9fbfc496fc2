#include <wheelrail/geometry/section_heights.h>

#include <cmath>
#include <utility>

// Cubic Hermite tables of heights, value and slope at each place: the error is that of a fourth derivative
// times spacing^4/384.

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


  SectionHeights::SectionHeights(FrameProfile profile)
    : profile_(std::make_shared<const FrameProfile>(std::move(profile)))
  {
  }


  void
  SectionHeights::tabulate(const double s0, const double s1)
  {
    table_ = HeightTable(*profile_, s0, s1);
  }
} // namespace wheelrail
