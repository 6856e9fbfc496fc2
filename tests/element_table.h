#pragma once

// A solution of half-spaces against an element table of CONTACT (tests/reference): x, y [mm], pressure,
// tractions [MPa], state, in the last column the slip.

#include <wheelrail/halfspace/problem.h>

#include "reference_table.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace test
{
  /// Checks the root mean square difference of pressure and tractions over their peaks, and how many elements
  /// have another state. Returns the largest difference of the slip over its peak.
  inline double
  check_element_table(const wheelrail::HalfspaceSolution          &s,
                      const std::vector<std::vector<std::string>> &table,
                      const double                                 limit,
                      const int                                    other_states)
  {
    double error[3] = {0, 0, 0}, peak[3] = {0, 0, 0}, slip_error = 0, slip_peak = 0;
    int    other = 0;
    for (const auto &row : table)
      {
        const auto number = [&](const int column) { return std::stod(row[column]); };
        const int  i      = int(std::round((number(0) * 1e-3 - s.grid.x0) / s.grid.dx)),
                  j = int(std::round((number(1) * 1e-3 - s.grid.y0) / s.grid.dy)), e = i + s.grid.mx * j;
        const double values[3] = {s.pressure[e], s.traction_x[e], s.traction_y[e]};
        for (int d = 0; d < 3; ++d)
          {
            error[d] += std::pow(values[d] - number(2 + d) * 1e6, 2);
            peak[d] = std::max(peak[d], std::abs(number(2 + d) * 1e6));
          }
        slip_error = std::max(slip_error, std::abs(std::hypot(s.slip_x[e], s.slip_y[e]) - number(11)));
        slip_peak  = std::max(slip_peak, number(11));
        other += int(s.state[e]) != std::stoi(row[5]);
      }
    const char *names[3] = {"pressure", "tx", "ty"};
    for (int d = 0; d < 3; ++d)
      {
        const double rms = std::sqrt(error[d] / table.size()) / peak[d];
        BOOST_TEST(rms < limit,
                   std::string(names[d]) + " of the element table, rms over peak " + std::to_string(rms));
      }
    BOOST_TEST(other <= other_states, std::to_string(other) + " elements of other state than in the table");
    return slip_error / slip_peak;
  }
} // namespace test
