#pragma once

#include <vector>

namespace wheelrail
{
  /// Mean and standard deviation of the values whose distance is at least `from`.
  struct Mean
  {
    double mean = 0, deviation = 0;
  };
  Mean
  mean_from(const std::vector<double> &distance, const std::vector<double> &values, double from);

  /// Distance from which the values, averaged over `window` behind each of them, stay within `tolerance`
  /// (in their unit) of `final_value`; the window takes out what repeats from cell to cell. Infinity when
  /// they never do. `distance` grows; both have the same length.
  double
  settled_after(const std::vector<double> &distance,
                const std::vector<double> &values,
                double                     final_value,
                double                     tolerance,
                double                     window);
} // namespace wheelrail
