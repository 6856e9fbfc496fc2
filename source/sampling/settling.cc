#include <wheelrail/sampling/settling.h>

#include <boost/math/statistics/linear_regression.hpp>
#include <boost/math/statistics/univariate_statistics.hpp>

#include <algorithm>
#include <cmath>

namespace wheelrail
{
  namespace
  {
    namespace statistics = boost::math::statistics;

    /// The rows of a stretch.
    struct Rows
    {
      std::vector<double> distance, values;
    };

    Rows
    rows_of(const std::vector<double> &distance, const std::vector<double> &values, const Range &stretch)
    {
      // round-off must not take a row at an end
      const double from = stretch.s0 - 1e-9, to = stretch.s1 + 1e-9;
      Rows         rows;
      for (std::size_t k = 0; k < values.size(); ++k)
        if (distance[k] >= from && distance[k] <= to)
          {
            rows.distance.push_back(distance[k]);
            rows.values.push_back(values[k]);
          }
      return rows;
    }
  } // namespace


  Mean
  mean_over(const std::vector<double> &distance, const std::vector<double> &values, const Range &stretch)
  {
    const std::vector<double> rows = rows_of(distance, values, stretch).values;
    return {rows.empty() ? std::nan("") : statistics::mean(rows),
            rows.size() > 1 ? std::sqrt(statistics::sample_variance(rows)) : 0.};
  }


  namespace
  {
    /// Means over `window` behind each value.
    std::vector<double>
    window_means(const std::vector<double> &distance, const std::vector<double> &values, const double window)
    {
      std::vector<double> means;
      double              sum   = 0;
      std::size_t         first = 0;
      for (std::size_t k = 0; k < values.size(); ++k)
        {
          sum += values[k];
          while (first < k && distance[first] <= distance[k] - window)
            sum -= values[first++];
          means.push_back(sum / double(k - first + 1));
        }
      return means;
    }
  } // namespace


  double
  settled_after(const std::vector<double> &distance,
                const std::vector<double> &values,
                const double               final_value,
                const double               tolerance,
                const double               window)
  {
    double     settled = std::numeric_limits<double>::infinity();
    const auto means   = window_means(distance, values, window);
    for (std::size_t k = 0; k < means.size(); ++k)
      if (!(std::abs(means[k] - final_value) <= tolerance))
        settled = std::numeric_limits<double>::infinity();
      else if (std::isinf(settled))
        settled = distance[k];
    return settled;
  }


  Trend
  trend_over(const std::vector<double> &distance,
             const std::vector<double> &values,
             const Range               &stretch,
             const double               window)
  {
    constexpr double most_blocks = 20, least_blocks = 4;
    const Rows       rows = rows_of(distance, values, stretch);
    const auto      &x = rows.distance, &y = rows.values;
    Trend            trend;
    if (x.empty())
      return trend;
    trend.mean   = statistics::mean(y);
    trend.middle = statistics::mean(x);
    if (x.back() > x.front()) // least squares
      trend.slope = statistics::simple_ordinary_least_squares(x, y).second;

    const double blocks = std::min(most_blocks, std::floor((x.back() - x.front()) / window + 1e-6));
    if (!(blocks >= least_blocks))
      return trend;
    std::vector<double> places(static_cast<std::size_t>(blocks)), rest(places.size()), count(places.size());
    for (std::size_t k = 0; k < x.size(); ++k)
      {
        const double      share = (x[k] - x.front()) / (x.back() - x.front());
        const std::size_t block = std::min(places.size() - 1, static_cast<std::size_t>(share * blocks));
        places[block] += x[k];
        rest[block] += y[k] - trend.at(x[k]);
        count[block] += 1;
      }
    double scatter = 0, spread = 0;
    for (std::size_t b = 0; b < places.size(); ++b)
      if (count[b] > 0)
        {
          const double away = places[b] / count[b] - trend.middle, off = rest[b] / count[b];
          spread += away * away;
          scatter += off * off;
        }
    trend.slope_error = std::sqrt(scatter / (blocks - 2) / spread);
    return trend;
  }


  Settling
  settling(const std::vector<double> &distance,
           const std::vector<double> &values,
           const Range               &stretch,
           const double               scale,
           const double               window)
  {
    const Trend  trend  = trend_over(distance, values, stretch, window);
    const double length = std::min(stretch.s1, distance.back()) - std::max(stretch.s0, distance.front());
    const bool   drifts = !(std::abs(trend.slope) <= 2 * trend.slope_error); // too few blocks: taken as it is
    Settling     result;
    result.drift = drifts ? std::abs(trend.slope) * length / scale : 0;

    std::vector<double> about = values; // the noise alone
    for (std::size_t k = 0; k < values.size(); ++k)
      about[k] -= trend.slope * (distance[k] - trend.middle);
    const Mean noise = mean_over(distance, window_means(distance, about, window), stretch);
    result.swing     = noise.deviation / scale;
    result.after     = std::numeric_limits<double>::infinity();
    if (!(result.swing <= 0.02 && result.drift <= 0.02)) // the line leaves 1 % at both ends
      return result;
    // what comes after the stretch does not speak against it
    const auto end = std::upper_bound(distance.begin(), distance.end(), stretch.s1) - distance.begin();
    std::vector<double> till(distance.begin(), distance.begin() + end),
      so_far(values.begin(), values.begin() + end);
    result.after =
      settled_after(till, so_far, trend.mean, std::max(0.01 * scale, 3 * noise.deviation), window);
    return result;
  }
} // namespace wheelrail
