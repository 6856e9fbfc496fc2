#pragma once

#include <wheelrail/profiles/profile_formats.h>

#include <string>
#include <vector>

namespace wheelrail
{
  /// Drops single points and pairs of points that lie off the line of their neighbours by more than eight
  /// times the noise, and 0.05 mm, however far. Kinks stay: without the point at a kink its neighbours do not
  /// lie on a line. Tells what was dropped in `notes`. Throws InputError when more than 5 % of the points are
  /// outliers.
  std::vector<FilePoint>
  without_outliers(std::vector<FilePoint> points, const std::string &file, std::vector<std::string> &notes);

  /// Standard deviation of the measurement noise normal to the outline [m]: the median distance of
  /// each point from the cubic through its two neighbours on both sides, scaled to a normal
  /// distribution. Kinks and outliers do not move it. Needs five points or more (0 otherwise).
  double
  estimated_noise(const std::vector<Point2> &points);
} // namespace wheelrail
