#pragma once

#include <wheelrail/geometry/frame_profile.h>

#include <vector>

namespace wheelrail
{
  /// Means of the values over the cells of `length` from the end of a stretch backwards, first cell first;
  /// what is less than a cell at its beginning is left out. Values are taken as straight between their
  /// distances, which grow [m], so that what repeats from cell to cell drops out of each mean whatever rows
  /// it has.
  std::vector<double>
  cell_means(const std::vector<double> &distance,
             const std::vector<double> &values,
             const Range               &stretch,
             double                     length);

  /// Standard error of the mean of means over cells that follow each other, in their unit. Neighbours are
  /// alike, so the scatter is taken between blocks of one cell, of two, three, ... as long as four blocks are
  /// left, and the largest counts, which grows with the blocks until these are as long as what makes
  /// neighbours alike (Flyvbjerg and Petersen 1989). The scatter of few blocks is uncertain: it is
  /// enlarged by Student's distribution, so that the true mean lies within two errors as often as within two
  /// of a normal distribution. Infinity for fewer than four cells.
  double
  standard_error(const std::vector<double> &means);
} // namespace wheelrail
