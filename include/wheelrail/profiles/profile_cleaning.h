#pragma once

#include <wheelrail/profiles/profile_formats.h>

#include <string>
#include <vector>

namespace wheelrail
{
  /// Cleans the points of one measured profile [m] so that they follow the outline once: repeated
  /// points merged, disorder sorted, overlapping pieces merged, outliers dropped, points
  /// closer than 0.1 mm averaged. The order may still run in either sense.
  ///
  /// Adds a sentence for everything that was changed to `notes`. Throws InputError that names file
  /// and lines for what cannot be mended: fewer than 20 points, a length outside 5 mm to 500 mm
  /// (says which unit would fit), overlaps that disagree by more than 0.5 mm, more than 5 % of outliers.
  std::vector<FilePoint>
  cleaned_points(std::vector<FilePoint> points, const std::string &file, std::vector<std::string> &notes);

  /// Fills steps of 10 mm to 30 mm on straight faces of what is kept of a profile, and notes shorter gaps.
  /// Throws InputError for gaps above 10 mm elsewhere, and loops.
  std::vector<FilePoint>
  bridged_points(const std::vector<FilePoint> &points,
                 const std::string            &file,
                 std::vector<std::string>     &notes);
} // namespace wheelrail
