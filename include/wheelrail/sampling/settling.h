#pragma once

#include <wheelrail/geometry/frame_profile.h>

#include <vector>

namespace wheelrail
{
  /// Mean and standard deviation of the values whose distance lies in a stretch, its ends included.
  struct Mean
  {
    double mean = 0, deviation = 0;
  };
  Mean
  mean_over(const std::vector<double> &distance, const std::vector<double> &values, const Range &stretch);

  /// Distance from which the values, averaged over `window` behind each of them, stay within `tolerance`
  /// (in their unit) of `final_value`; the window takes out what repeats from cell to cell. Infinity when
  /// they never do. `distance` grows; both have the same length.
  double
  settled_after(const std::vector<double> &distance,
                const std::vector<double> &values,
                double                     final_value,
                double                     tolerance,
                double                     window);

  /// From where on a figure is steady, and how much it still swings there.
  struct Settling
  {
    double after = 0; ///< [m]; infinity when it swings too much to be called steady
    double swing = 0; ///< standard deviation of its means over the window in that stretch, over `scale`
  };

  /// Settling of a figure to its mean over a stretch of the distance. Judged are means over
  /// `window`. A figure is steady from where they stay within 1 % of `scale`, or within three of their own
  /// standard deviations in that stretch where those are larger, since noise that goes on to the end
  /// belongs to the figure. A figure whose deviation there exceeds 2 % of `scale` is never steady.
  /// `scale` > 0 is what the figure is judged by: its mean, or something larger where that is about zero.
  Settling
  settling(const std::vector<double> &distance,
           const std::vector<double> &values,
           const Range               &stretch,
           double                     scale,
           double                     window);
} // namespace wheelrail
