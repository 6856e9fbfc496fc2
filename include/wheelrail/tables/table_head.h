#pragma once

#include <wheelrail/base/quantity.h>
#include <wheelrail/tables/table.h>

#include <optional>
#include <string>
#include <vector>

namespace wheelrail
{
  /// A cell of the first line: "load [kN]".
  struct TableHead
  {
    std::string cell; ///< as it stands
    std::string name; ///< in small letters, with blanks between words
    std::string unit;
    bool        has_unit = false;
    double      factor   = 1; ///< by which a table of names multiplies the column
  };

  /// The cells of a first line. Between blanks a name with its unit in brackets is one.
  std::vector<std::string>
  heads_of(const std::string &line);

  /// What one of a unit is [SI]: "m_per_s" and "m_s" are m/s, too. The letter mu and superscripts may be
  /// those of Latin-1. Nothing where it is no unit of this dimension.
  std::optional<double>
  factor_of(std::string unit, Dimension dimension);

  /// The factor before a name, as in "-load" or "9.81 * load", which is taken off; 1 where there is none.
  double
  take_factor(std::string &name);

  /// A name in small letters, with blanks between words.
  std::string
  plain_name(const std::string &text);

  /// Name and unit of a cell of the first line: units stand in brackets or behind a known name.
  TableHead
  head_of(const std::string &cell, const std::vector<TableColumn> &known);
} // namespace wheelrail
