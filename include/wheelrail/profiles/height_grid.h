#pragma once

#include <wheelrail/geometry/curve.h>
#include <wheelrail/geometry/irregularity.h>

#include <string>
#include <vector>

namespace wheelrail
{
  /// Measured heights of a surface over its smooth shape, on a grid or along one line [m].
  struct HeightGrid
  {
    std::vector<double> along;  ///< ascending
    std::vector<double> across; ///< ascending, positive to the field side; empty: a line, alike all across
    std::vector<double> height; ///< along fastest
    std::vector<std::string> notes;     ///< what of the file was left out
    double                   noise = 0; ///< standard deviation of the heights, of slices each as a whole [m]
  };

  /// Reads a table (CSV: a line with names and units, then rows along, across, height in any order, or along,
  /// height for a line) or the HDF5 file of a grid (datasets along_mm, across_mm, height_um with one row of
  /// heights for each place across). Names are along, across, height with _m, _mm or _um.
  ///
  /// Throws InputError that names file and line, what was found and what is accepted: no number, unknown
  /// names, the same place twice, places of the grid without a row, fewer than four places along or across.
  HeightGrid
  read_height_file(const std::string &path);

  /// The irregularity of heights, as bicubic splines of the grid or a cubic spline of the line, with the
  /// file's origin at `place` along and `lateral` across. Beside the grid the heights of its edge hold;
  /// before and behind it there is none, but on a wheel of `circumference` that the grid goes around
  /// [m].
  Irregularity
  grid_irregularity(const HeightGrid &grid, double place, double lateral, double circumference);

  /// The same of heights that were measured one by one, smoothed where they have noise.
  Irregularity
  measured_irregularity(const HeightGrid &grid, double place, double lateral, double circumference);

  /// How high the first and the last places along stand over the smooth surface [m]: a step.
  double
  largest_end(const HeightGrid &grid);

  /// Where the slope of measured heights jumps along, by what it changes between their places: over a step
  /// twice as large a kink has the same jump, a jump of the curvature twice and a smooth shape eight times
  /// the jump. What noise may make is none. Beyond the ends their heights hold, or those of a wheel that is
  /// measured all around (`circumference`, else 0) [m].
  std::vector<Kink>
  kinks_of(const HeightGrid &grid, double circumference);
} // namespace wheelrail
