#pragma once

#include <wheelrail/output/summary.h>

#include <string>
#include <vector>

namespace wheelrail
{
  /// SI unit of a figure or an end of its interval, by its key; "1" of all else.
  std::string
  unit_of(const std::string &key);

  /// Numbers of several cases: one column a figure, under its key of summary.json, or another name.
  struct FigureTable
  {
    std::vector<std::string>         keys;
    std::vector<std::string>         units;   ///< "Pa"; "1" of pure numbers
    std::vector<std::vector<double>> columns; ///< [its unit], one value a case; NaN where there is none

    /// A column of values under a key.
    void
    add(const std::string &key, const std::string &unit, std::vector<double> values);

    /// Empty columns of keys and their units: "case 1, line 1, approach_m m".
    void
    add_columns(const std::string &keys_and_units);

    /// A row of one value for each of the columns.
    void
    add_row(const std::vector<double> &values);

    /// The columns of those of `wanted` that at least one of the summaries has, under `before` and their key.
    void
    add_figures(const std::vector<std::string> &wanted,
                const std::vector<Summary>     &summaries,
                const std::string              &before = "");

    /// The column with that key, or null.
    const std::vector<double> *
    find(const std::string &key) const;

    std::size_t
    rows() const;

    /// Keys first, commas between; empty where there is no value.
    std::string
    as_csv() const;

    /// Throws RunError when it cannot be written.
    void
    write_csv(const std::string &path) const;

    /// One dataset a column, as write_history() has it. Throws RunError when it cannot be written.
    void
    write_hdf5(const std::string &path) const;
  };
} // namespace wheelrail
