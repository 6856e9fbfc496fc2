#include <wheelrail/profiles/height_kinks.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>

namespace wheelrail
{
  namespace
  {
    /// A line of heights over the places along that goes on beyond its ends.
    struct EndlessLine
    {
      const std::vector<double> &along;
      const double              *height;
      double                     circumference; ///< 0: the heights of the ends hold

      Point2
      operator()(const std::ptrdiff_t k) const
      {
        const auto n = static_cast<std::ptrdiff_t>(along.size());
        if (k >= 0 && k < n)
          return {along[k], height[k]};
        if (circumference > 0)
          return {along[(k + n) % n] + (k < 0 ? -circumference : circumference), height[(k + n) % n]};
        const double step = (along.back() - along.front()) / (n - 1);
        return k < 0 ? Point2{along.front() + k * step, height[0]}
                     : Point2{along.back() + (k - n + 1) * step, height[n - 1]};
      }
    };

    /// By how much the slope changes from the places before `a` to those behind `b`, each `step` places
    /// apart, less what it changes beside them over the same length.
    double
    jump_between(const EndlessLine   &line,
                 const std::ptrdiff_t a,
                 const std::ptrdiff_t b,
                 const std::ptrdiff_t step)
    {
      struct Slope
      {
        double at, value;
      };
      const auto slope = [&](const std::ptrdiff_t from) {
        const Point2 p = line(from), q = line(from + step);
        return Slope{0.5 * (p.x + q.x), (q.y - p.y) / (q.x - p.x)};
      };
      const Slope before = slope(a - 2 * step), behind = slope(a - step), ahead = slope(b),
                  beyond = slope(b + step);
      return ahead.value - behind.value -
             0.5 * (ahead.at - behind.at) *
               ((beyond.value - ahead.value) / (beyond.at - ahead.at) +
                (behind.value - before.value) / (behind.at - before.at));
    }

    /// The jump between places k and k + 1 as their distance goes to nothing. 0 where it differs by more than
    /// a fifth from that over the distance itself: beside a kink, and where the surface is round.
    double
    remaining_jump(const EndlessLine &line, const std::ptrdiff_t k)
    {
      const double jump = jump_between(line, k, k + 1, 1), one = jump_between(line, k, k + 2, 2),
                   other     = jump_between(line, k - 1, k + 1, 2),
                   remaining = 2 * jump - (jump > 0 ? std::max(one, other) : std::min(one, other));
      return std::abs(remaining - jump) < 0.2 * std::abs(jump) ? remaining : 0;
    }
  } // namespace


  std::vector<Kink>
  kinks_of(const HeightGrid &grid, const double circumference)
  {
    constexpr double least = 1e-3; // [rad], adds 1 % to 1200 MPa with each halving
    // four standard deviations of remaining_jump() times the step [m]; digits of a file are noise, too
    const double                   noise = 48 * std::max(grid.noise, 2e-8);
    const auto                     n     = static_cast<std::ptrdiff_t>(grid.along.size());
    std::map<std::ptrdiff_t, Kink> found;
    if (n < 8) // too few to tell a kink from a round shape
      return {};
    for (const double *row = grid.height.data(); row != grid.height.data() + grid.height.size(); row += n)
      {
        const EndlessLine line{grid.along, row, circumference};
        for (std::ptrdiff_t k = -1; k < n; ++k)
          {
            const double from = line(k).x, to = line(k + 1).x;
            if (std::abs(remaining_jump(line, k)) > std::max(least, noise / (to - from)))
              found[k] = {0.5 * (from + to), to - from};
          }
      }
    std::vector<Kink> kinks;
    for (const auto &[unused, kink] : found)
      kinks.push_back(kink);
    return kinks;
  }
} // namespace wheelrail
