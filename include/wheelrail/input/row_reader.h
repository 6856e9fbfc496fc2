#pragma once

#include <wheelrail/input/motion_columns.h>
#include <wheelrail/input/motion_file.h>

#include <map>
#include <string>

namespace wheelrail
{
  /// What the columns of a file are called here: name in the file -> name and, where the file has none, unit.
  using ColumnNames = std::map<std::string, std::string>;

  /// How a table of rows is read.
  struct RowOptions
  {
    std::string purpose;        ///< what needs the file, for messages
    bool        leaves = false; ///< columns that are not known are left out with a note
    ColumnNames names;          ///< what columns of other programs are called here
  };

  /// Reads a table with semicolons, commas or tabs between and a first line that names each column and its
  /// unit, "load [kN]"; units may also stand in a second line by themselves. Between semicolons or tabs a
  /// number may have a decimal comma. Throws InputError, with file, line and column, for everything else; a
  /// name that resembles a known one is never left out.
  MotionFile
  read_rows(const std::string &path, const MotionColumns &known, const RowOptions &options);

  /// Reads a table of two columns: the name in the file, and the name here with its unit, "y_ws;lateral
  /// shift [mm]". A minus before the name turns the sign of the column. Throws InputError.
  ColumnNames
  read_column_names(const std::string &path);
} // namespace wheelrail
