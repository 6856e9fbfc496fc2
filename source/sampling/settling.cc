#include <wheelrail/sampling/settling.h>

#include <cmath>
#include <limits>

namespace wheelrail
{
  Mean
  mean_from(const std::vector<double> &distance, const std::vector<double> &values, const double from)
  {
    double n = 0, sum = 0, squares = 0;
    for (std::size_t k = 0; k < values.size(); ++k)
      if (distance[k] >= from)
        {
          n += 1;
          sum += values[k];
        }
    const double mean = n > 0 ? sum / n : std::nan("");
    for (std::size_t k = 0; k < values.size(); ++k)
      if (distance[k] >= from)
        squares += (values[k] - mean) * (values[k] - mean);
    return {mean, n > 1 ? std::sqrt(squares / (n - 1)) : 0.};
  }


  double
  settled_after(const std::vector<double> &distance,
                const std::vector<double> &values,
                const double               final_value,
                const double               tolerance,
                const double               window)
  {
    double      settled = std::numeric_limits<double>::infinity();
    double      sum     = 0;
    std::size_t first   = 0;
    for (std::size_t k = 0; k < values.size(); ++k)
      {
        sum += values[k];
        while (first < k && distance[first] <= distance[k] - window)
          sum -= values[first++];
        const double mean = sum / double(k - first + 1);
        if (!(std::abs(mean - final_value) <= tolerance))
          settled = std::numeric_limits<double>::infinity();
        else if (std::isinf(settled))
          settled = distance[k];
      }
    return settled;
  }
} // namespace wheelrail
