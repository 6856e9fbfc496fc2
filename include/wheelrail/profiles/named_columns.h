#pragma once

#include <string>
#include <utility>
#include <vector>

namespace wheelrail
{
  /// A column that a table may have: the name of its quantity, and for each ending of the name that tells a
  /// unit the factor to SI.
  struct NamedColumn
  {
    std::string                                 quantity; ///< such as along
    std::vector<std::pair<std::string, double>> units;    ///< such as _mm, 1e-3
    bool                                        needed = true;
  };

  /// The endings of lengths: _m, _mm, _um.
  std::vector<std::pair<std::string, double>>
  length_units();

  /// A row of a table: a value for each of the columns that were asked for, 0 for one that it lacks [SI].
  struct NamedRow
  {
    std::vector<double> value;
    unsigned int        line = 0; ///< of the file, counted from 1
  };

  struct NamedTable
  {
    std::vector<bool>     has; ///< for each column that was asked for: whether the table has it
    std::vector<NamedRow> rows;
  };

  /// The factor of a column's name, 0 where it is another quantity or has no known unit.
  double
  unit_of(const std::string &name, const NamedColumn &column);

  /// Reads a table: a line of names, then rows of numbers, between blanks, tabs, commas or semicolons;
  /// comments begin with #, % or !. Columns may stand in any order, others are left out. Throws InputError
  /// that names file and line: no such file, empty, a needed column that lacks, no number; with `accepted` at
  /// its end, what a table must hold.
  NamedTable
  read_named_columns(const std::string              &path,
                     const std::vector<NamedColumn> &columns,
                     const std::string              &accepted);
} // namespace wheelrail
