#pragma once

#include <string>
#include <vector>

namespace wheelrail
{
  /// Numbers of a command line.
  struct ValueList
  {
    std::vector<double> values;
    std::string         fault; ///< what is wrong with the text; empty: nothing
  };

  /// Reads "first:last:step" or "value, value, ..."; more than `most` values are a fault.
  ValueList
  parse_value_list(const std::string &text, double most);
} // namespace wheelrail
