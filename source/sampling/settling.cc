#include <wheelrail/sampling/settling.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace wheelrail
{
  Mean
  mean_over(const std::vector<double> &distance, const std::vector<double> &values, const Range &stretch)
  {
    // round-off must not take a row at an end
    const double from = stretch.s0 - 1e-9, to = stretch.s1 + 1e-9;
    double       n = 0, sum = 0, squares = 0;
    for (std::size_t k = 0; k < values.size(); ++k)
      if (distance[k] >= from && distance[k] <= to)
        {
          n += 1;
          sum += values[k];
        }
    const double mean = n > 0 ? sum / n : std::nan("");
    for (std::size_t k = 0; k < values.size(); ++k)
      if (distance[k] >= from && distance[k] <= to)
        squares += (values[k] - mean) * (values[k] - mean);
    return {mean, n > 1 ? std::sqrt(squares / (n - 1)) : 0.};
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


  Settling
  settling(const std::vector<double> &distance,
           const std::vector<double> &values,
           const Range               &stretch,
           const double               scale,
           const double               window)
  {
    const Mean   noise = mean_over(distance, window_means(distance, values, window), stretch);
    const double swing = noise.deviation / scale;
    if (!(swing <= 0.02))
      return {std::numeric_limits<double>::infinity(), swing};
    const double final = mean_over(distance, values, stretch).mean;
    // what comes after the stretch does not speak against it
    const auto end = std::upper_bound(distance.begin(), distance.end(), stretch.s1) - distance.begin();
    std::vector<double> till(distance.begin(), distance.begin() + end),
      so_far(values.begin(), values.begin() + end);
    return {settled_after(till, so_far, final, std::max(0.01 * scale, 3 * noise.deviation), window), swing};
  }
} // namespace wheelrail
