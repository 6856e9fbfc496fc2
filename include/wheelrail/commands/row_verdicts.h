#pragma once

#include <wheelrail/verdict/verdict.h>

#include <ostream>
#include <string>
#include <vector>

namespace wheelrail
{
  /// How far one row of a table can be trusted.
  struct RowVerdict
  {
    std::string where; ///< such as "row 3, left wheel"
    Grade       grade = Grade::trusted;
    std::string doubts; ///< empty: none
  };

  /// Prints how many rows have which verdict, then why of the first few that are not trusted or to be taken
  /// with care. `what` they are ("places"); `column` is that of the table which has all ("verdict of
  /// places.csv").
  void
  print_row_verdicts(const std::vector<RowVerdict> &rows,
                     const std::string             &what,
                     const std::string             &column,
                     std::ostream                  &out);
} // namespace wheelrail
