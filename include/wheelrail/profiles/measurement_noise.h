#pragma once

#include <wheelrail/geometry/curve.h>

#include <vector>

namespace wheelrail
{
  /// The middle one of some values; 0 of none.
  double
  median(std::vector<double> values);

  /// Standard deviation of the scatter of each point normal to the outline [m]: the median distance of the
  /// points around it from the polynomial through their neighbours, `beside` on either side (two: a cubic),
  /// scaled to a normal distribution; within 12 mm or 20 points to either side, or of all points where that
  /// is more, so that exact stretches do not lower it. Kinks and outliers do not move it. Needs five points
  /// or more (0 otherwise).
  std::vector<double>
  estimated_scatter(const std::vector<Point2> &points, std::size_t beside = 2);

  /// The steps of which the differences of all x, and of all y, are multiples: 1, 2 or 5 times a power of
  /// ten, in the unit of the points; 0 where there is none, and where nearly all steps are one.
  Point2
  rounding_of(const std::vector<Point2> &points);

  /// Standard deviation of each point from the outline [m], of scatter and of the rounding of its coordinates
  /// [m]. Points that rounding puts on one line have one error together: they count as one.
  std::vector<double>
  deviation_of(const std::vector<Point2> &points, const Point2 &rounding);
} // namespace wheelrail
