#pragma once

#include <string>
#include <vector>

namespace wheelrail
{
  struct Summary;

  /// A figure of a run: what it is called in summary.json and how it is shown. This is the only place of
  /// labels, units and signs; screens, the command `compare` and the pages take theirs from here.
  struct Figure
  {
    const char *name;       ///< "max_pressure": the key without its unit
    const char *si;         ///< SI unit as in the key, "Pa"; empty for pure numbers
    const char *label;      ///< for reading: "peak pressure"
    const char *remark;     ///< "positive forward", or what it is relative to; empty when it needs none
    const char *unit;       ///< shown: "MPa"
    double      factor;     ///< from SI to the unit shown
    int         decimals;   ///< shown
    bool        count;      ///< a whole number
    double Summary::*value; ///< its member; null for figures among Summary::further

    /// Key in summary.json: name and SI unit, the tail between them: "max_pressure_std_Pa".
    std::string
    key(const std::string &tail = "") const;
    /// SI unit as it is written: "m/s", "1/m", "Pa"; "1" of pure numbers.
    std::string
    si_unit() const;
    /// The value in the unit shown, without it; "-" when it is not finite.
    std::string
    shown(double value) const;
  };

  /// All figures, those of the members of Summary first, in the order of the file.
  const std::vector<Figure> &
  all_figures();

  /// The figure with that name; throws std::logic_error when there is none.
  const Figure &
  figure_named(const std::string &name);

  /// The figure with that key ("max_pressure_Pa"), or null.
  const Figure *
  figure_with_key(const std::string &key);

  /// The table as JSON, an array of one object a figure with key, std_key (of its standard deviation),
  /// error_key, low_key and high_key (of its interval), label, remark, unit, factor and decimals.
  std::string
  figures_as_json();
} // namespace wheelrail
