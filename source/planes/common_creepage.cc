#include <wheelrail/planes/common_creepage.h>

#include <boost/math/tools/roots.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace wheelrail
{
  CreepageFound
  find_creepage(const std::function<double(double)> &missed, const double first)
  {
    // 1. a bracket: `missed` grows with the creepage, so that steps go against its sign, each four times the
    // last
    double low = first, f_low = missed(low), high = low, f_high = f_low;
    for (double step = 1e-4; f_high * f_low > 0; step *= 4)
      {
        low   = high;
        f_low = f_high;
        high  = std::clamp(low - std::copysign(step, f_low), -1., 1.);
        if (high == low)
          return {false, high}; // locked, or twice as fast, and still not enough
        f_high = missed(high);
      }
    if (f_high == 0)
      return {true, high};
    if (high < low)
      {
        std::swap(low, high);
        std::swap(f_low, f_high);
      }
    // 2. inside it by inverse cubic interpolation (Alefeld, Potra and Shi 1995, TOMS 748)
    const auto     close = [](const double a, const double b) { return std::abs(b - a) < 1e-10; };
    std::uintmax_t steps = 40;
    const auto     range = boost::math::tools::toms748_solve(missed, low, high, f_low, f_high, close, steps);
    return {true, 0.5 * (range.first + range.second)};
  }
} // namespace wheelrail
