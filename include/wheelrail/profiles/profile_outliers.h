#pragma once

#include <wheelrail/profiles/profile_formats.h>

#include <string>
#include <vector>

namespace wheelrail
{
  /// Drops single points and pairs of points that lie off the line of their neighbours by more than eight
  /// times the scatter around, and 0.05 mm, however far. Kinks stay: without the point at a kink its
  /// neighbours do not lie on a line. Tells what was dropped in `notes`. Throws InputError when more than 5 %
  /// of the points are outliers.
  std::vector<FilePoint>
  without_outliers(std::vector<FilePoint> points, const std::string &file, std::vector<std::string> &notes);
} // namespace wheelrail
