#pragma once

#include <wheelrail/output/summary.h>

#include <limits>
#include <string>
#include <vector>

namespace wheelrail
{
  /// What one cause leaves open of a result, in the result's SI unit: because of it the true value lies
  /// about `shift` above the reported one, and in 95 of 100 cases within `spread` of that. A spread that is
  /// not finite: not known, so that the result has no interval.
  struct Contribution
  {
    std::string result; ///< its name in the table of figures
    std::string cause;  ///< "elements", "measured input", ...
    double      shift = 0, spread = 0;
  };

  using Contributions = std::vector<Contribution>;

  /// Where the true value lies, in 95 of 100 cases.
  struct Interval
  {
    double low, high;
  };

  /// Known shifts S add up, spreads are independent and add by their squares to D^2; the true value lies
  /// within value + S -+ D. The interval reaches to the reported value where this lies outside:
  ///   low = value + min(0, S - D), high = value + max(0, S + D)
  /// and to what the result can be: friction work from 0, the sticking part from 0 to 1
  /// (doc/theory/intervals.md). NaN: nothing is known of it.
  Interval
  interval_of(const std::string &result, double value, const Contributions &contributions);

  /// How well a result is known: the farther side of its interval over it, and the cause with most part in
  /// that. NaN: it has no interval.
  struct Known
  {
    double      within = std::numeric_limits<double>::quiet_NaN();
    std::string cause;
  };

  /// `least`: below it the result does not matter, and its interval is held against that.
  Known
  known_within(const std::string &result, double value, double least, const Contributions &contributions);

  /// Sets "max_pressure_low_Pa", "max_pressure_high_Pa" and the like of results that have an interval.
  void
  set_intervals(const Contributions &contributions, Summary &summary);

  /// "1225.1 to 1252.3" in the unit in which the figure is shown, of its keys in a summary; empty: it has
  /// none.
  std::string
  shown_interval(const Summary &summary, const std::string &figure);

  /// The keys of both ends of the interval of a figure with a key ("max_pressure_Pa").
  std::vector<std::string>
  interval_keys(const std::string &key);

  /// All contributions as a CSV table: result, unit, cause, shift, spread, in the order of the figures.
  std::string
  contributions_as_csv(const Contributions &contributions);
} // namespace wheelrail
