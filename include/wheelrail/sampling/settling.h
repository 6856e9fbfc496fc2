#pragma once

#include <wheelrail/geometry/frame_profile.h>

#include <limits>
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

  /// A straight line through values over a stretch of the distance (least squares), and how well it is known.
  /// What repeats from cell to cell makes neighbouring values alike, so the scatter is that of means over
  /// blocks of `window` and more, twenty at most, which count as independent (block averages: Flyvbjerg and
  /// Petersen 1989).
  struct Trend
  {
    double mean = 0, slope = 0; ///< value in the middle of the stretch [its unit], and its change [1/m]
    double middle      = 0;     ///< of the stretch [m]
    double slope_error = std::numeric_limits<double>::quiet_NaN(); ///< of the slope; NaN: too few blocks

    double
    at(const double place) const
    {
      return mean + slope * (place - middle);
    }
  };
  Trend
  trend_over(const std::vector<double> &distance,
             const std::vector<double> &values,
             const Range               &stretch,
             double                     window);

  /// From where on a figure is steady, how much it swings there, and how much it still changes.
  struct Settling
  {
    double after = 0; ///< [m]; infinity when it swings too much to be called steady
    double swing = 0; ///< standard deviation about the trend of its means over the window, over `scale`
    double drift = 0; ///< what the trend comes to over the stretch, over `scale`; 0 where it may be noise
  };

  /// Settling of a figure to its mean over a stretch of the distance. Slope and noise are judged apart. A
  /// trend counts once it is twice its own error. Noise are means over `window` about the trend: a figure is
  /// steady from where they stay within 1 % of `scale` of its mean, or within three standard deviations of
  /// the noise where those are larger, since noise that lasts to the end belongs to the figure. A figure
  /// whose noise, or whose trend over the stretch, exceeds 2 % of `scale` is never steady. `scale` > 0 is
  /// what the figure is judged by: its mean, or something larger where that is about zero.
  Settling
  settling(const std::vector<double> &distance,
           const std::vector<double> &values,
           const Range               &stretch,
           double                     scale,
           double                     window);
} // namespace wheelrail
