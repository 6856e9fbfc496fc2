#pragma once

#include <wheelrail/base/quantity.h>

#include <map>
#include <string>
#include <vector>

namespace wheelrail
{
  /// A column that a table of rows may have.
  struct TableColumn
  {
    const char *name; ///< as messages have it, "load right"; capital letters and "_" for blanks do not matter
    Dimension   dimension;
    double      least, most; ///< accepted [SI]
    const char *range;       ///< the same in words
    bool        needed       = false;
    bool        grows        = false; ///< from row to row
    double      least_amount = 0;     ///< values nearer to 0 are refused, but 0 itself
  };

  /// What the columns of a file are called here: name in the file -> name here with a factor before it,
  /// "-load" or "9.81 * load", and, where the file has none, unit.
  using ColumnNames = std::map<std::string, std::string>;

  /// How a table of rows is read.
  struct TableOptions
  {
    std::string purpose;           ///< what needs the file and what it holds, for messages
    bool        leaves    = false; ///< columns that are not known are left out with a note
    ColumnNames names     = {};    ///< what columns of other programs are called here
    const char *remarks   = "#";   ///< with what remarks begin
    const char *otherwise = "";    ///< the first line of a file that begins with numbers
    const char *renaming  = "";    ///< option that takes `names`, for messages
  };

  /// Rows of numbers under names.
  struct Table
  {
    std::vector<std::size_t>         known;   ///< for each column: which of those that were asked for
    std::vector<std::vector<double>> columns; ///< [SI], one value a row
    std::vector<unsigned int>        lines;   ///< of the rows, counted from 1
    std::vector<std::string>         notes;   ///< what of the file was left out, sentences

    /// The column that was asked for in this place, or null.
    const std::vector<double> *
    find(std::size_t known) const;
  };

  /// Reads a table with semicolons, tabs, commas or blanks between and a first line that names each column
  /// and its unit, "load [kN]", "load (kN)", "load / kN" or "load_kN", in any order, small or capital
  /// letters; units may also stand in a second line by themselves. Numbers may have decimal commas where
  /// something else or quotation marks part the columns. Throws InputError, with file, line and column, for
  /// everything else: a row with another number of cells than the first line, gaps, words, numbers out of
  /// range; a name that resembles a known one is never left out.
  Table
  read_table(const std::string &path, const std::vector<TableColumn> &known, const TableOptions &options);

  /// Reads a table of two columns: the name in the file, and the name here with its unit, "y_ws;lateral
  /// shift [mm]". A factor before the name multiplies the column: "-lateral shift", "9.81 * load". Throws
  /// InputError.
  ColumnNames
  read_column_names(const std::string &path, const std::vector<TableColumn> &known);
} // namespace wheelrail
