#pragma once

#include <string>
#include <vector>

namespace wheelrail
{
  /// Distances of two undeformed surfaces on a regular grid, cubic in between (bilinear facets would cost
  /// 3 % of the peak pressure on steps of 0.4 mm).
  struct DistanceTable
  {
    std::vector<double> x, y;     ///< along the rolling direction and across, growing [m]
    std::vector<double> distance; ///< x.size() * y.size(), x fastest [m]

    /// At a place inside of the grid; outside, the value at the nearest place of its rim.
    double
    at(double place_x, double place_y) const;
  };

  /// Reads rows of three numbers x, y, distance in mm, in any order, one for each point of a regular grid;
  /// what follows # is a remark, commas count as blanks. Throws InputError with file and line for rows that
  /// are not three numbers, places that are missing or come twice, uneven steps (by more than 1 % of a
  /// step) and fewer than four lines each way.
  DistanceTable
  read_distance_file(const std::string &path);
} // namespace wheelrail
