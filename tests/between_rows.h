#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace test
{
  /// The value at x of a line through the points (places, values), places ascending, two at least; the first
  /// or the last value beyond them.
  inline double
  between_rows(const std::vector<double> &places, const std::vector<double> &values, const double x)
  {
    const auto   after = std::upper_bound(places.begin(), places.end(), x);
    const auto   i     = std::clamp<std::ptrdiff_t>(after - places.begin(), 1, places.size() - 1);
    const double part  = std::clamp((x - places[i - 1]) / (places[i] - places[i - 1]), 0., 1.);
    return values[i - 1] + part * (values[i] - values[i - 1]);
  }
} // namespace test
