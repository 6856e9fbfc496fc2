#include <wheelrail/sections/cubic_spline.h>

#include <algorithm>
#include <utility>

namespace wheelrail
{
  std::vector<double>
  second_derivatives(const std::vector<double> &places,
                     const std::vector<double> &values,
                     const SplineEnds           ends)
  {
    const std::size_t   n = places.size(), last = n - 1;
    const bool          natural = ends == SplineEnds::natural;
    std::vector<double> second(n, 0.), diagonal(n), upper(n);
    const auto          h = [&](const std::size_t k) { return places[k + 1] - places[k]; };
    const auto          d = [&](const std::size_t k) { return (values[k + 1] - values[k]) / h(k); };
    for (std::size_t k = 1; k < last; ++k)
      {
        double lower = h(k - 1);
        diagonal[k]  = 2 * (h(k - 1) + h(k));
        upper[k]     = h(k);
        second[k]    = 6 * (d(k) - d(k - 1));
        if (k == 1 && !natural) // the first second derivative follows from the next two
          {
            diagonal[k] += h(0) * (h(0) + h(1)) / h(1);
            upper[k] -= h(0) * h(0) / h(1);
          }
        if (k + 1 == last && !natural)
          {
            diagonal[k] += h(k) * (h(k) + h(k - 1)) / h(k - 1);
            lower -= h(k) * h(k) / h(k - 1);
          }
        if (k > 1)
          {
            const double f = lower / diagonal[k - 1];
            diagonal[k] -= f * upper[k - 1];
            second[k] -= f * second[k - 1];
          }
      }
    for (std::size_t k = last; k-- > 1;)
      second[k] = (second[k] - (k + 1 < last ? upper[k] * second[k + 1] : 0)) / diagonal[k];
    if (natural)
      return second;
    second[0]      = ((h(0) + h(1)) * second[1] - h(0) * second[2]) / h(1);
    const double a = h(last - 1), b = h(last - 2);
    second[last] = ((a + b) * second[last - 1] - a * second[last - 2]) / b;
    return second;
  }


  std::vector<double>
  smoothed_values(const std::vector<double> &places,
                  const std::vector<double> &values,
                  const std::vector<double> &weights,
                  const double               lambda)
  {
    const std::size_t n = places.size();
    if (n < 3)
      return values;
    const auto h = [&](const std::size_t k) { return places[k + 1] - places[k]; };
    // second differences Q'; second derivatives g of f follow from (R + lambda Q' W^-1 Q) g = Q' values
    const auto q = [&](const std::size_t k, const std::size_t i) {
      return i + 1 == k ? 1 / h(k - 1) : i == k + 1 ? 1 / h(k) : i == k ? -1 / h(k - 1) - 1 / h(k) : 0;
    };
    const auto entry = [&](const std::size_t k, const std::size_t l) { // l from k to k + 2
      double sum = l == k ? (h(k - 1) + h(k)) / 3 : l == k + 1 ? h(k) / 6 : 0;
      for (std::size_t i = l - 1; i <= k + 1; ++i)
        sum += lambda * q(k, i) * q(l, i) / weights[i];
      return sum;
    };
    // L D L' of the matrix, which has two bands beside its diagonal
    std::vector<double> g(n, 0.), diagonal(n, 0.), one(n, 0.), two(n, 0.);
    for (std::size_t k = 1; k + 1 < n; ++k)
      {
        diagonal[k] = entry(k, k) - one[k - 1] * one[k - 1] * diagonal[k - 1];
        g[k]        = q(k, k - 1) * values[k - 1] + q(k, k) * values[k] + q(k, k + 1) * values[k + 1] -
               one[k - 1] * g[k - 1];
        if (k > 2)
          {
            diagonal[k] -= two[k - 2] * two[k - 2] * diagonal[k - 2];
            g[k] -= two[k - 2] * g[k - 2];
          }
        if (k + 2 < n)
          one[k] = (entry(k, k + 1) - one[k - 1] * two[k - 1] * diagonal[k - 1]) / diagonal[k];
        if (k + 3 < n)
          two[k] = entry(k, k + 2) / diagonal[k];
      }
    for (std::size_t k = n - 2; k > 0; --k)
      g[k] = g[k] / diagonal[k] - one[k] * g[k + 1] - (k + 2 < n ? two[k] * g[k + 2] : 0);
    std::vector<double> smooth = values;
    for (std::size_t k = 1; k + 1 < n; ++k)
      for (std::size_t i = k - 1; i <= k + 1; ++i)
        smooth[i] -= lambda * q(k, i) * g[k] / weights[i];
    return smooth;
  }


  CubicSpline::CubicSpline(std::vector<double> places, std::vector<double> values)
    : places_(std::move(places))
    , values_(std::move(values))
    , second_(second_derivatives(places_, values_, SplineEnds::not_a_knot))
  {
  }


  CubicSpline::Value
  CubicSpline::at(const double place) const
  {
    const auto        above = std::upper_bound(places_.begin() + 1, places_.end() - 1, place);
    const std::size_t k     = above - places_.begin() - 1;
    const double      h = places_[k + 1] - places_[k], b = (place - places_[k]) / h, a = 1 - b;
    return {a * values_[k] + b * values_[k + 1] +
              h * h / 6 * (a * (a * a - 1) * second_[k] + b * (b * b - 1) * second_[k + 1]),
            (values_[k + 1] - values_[k]) / h +
              h / 6 * ((1 - 3 * a * a) * second_[k] + (3 * b * b - 1) * second_[k + 1])};
  }


  SplineWeights
  spline_weights(const std::vector<double> &places, const double place)
  {
    constexpr std::size_t reach = 18; // what a place adds falls by 0.27 from one to the next
    const std::size_t     n     = places.size();
    const std::size_t     k     = std::upper_bound(places.begin(), places.end(), place) - places.begin();
    SplineWeights         weights;
    weights.first           = k > reach ? k - reach : 0;
    const std::size_t   end = std::min(n, k + reach);
    std::vector<double> unit(n, 0.);
    for (std::size_t i = weights.first; i < end; ++i)
      {
        unit[i]          = 1;
        const auto value = CubicSpline(places, unit).at(place);
        unit[i]          = 0;
        weights.value.push_back(value.value);
        weights.slope.push_back(value.slope);
      }
    return weights;
  }
} // namespace wheelrail
