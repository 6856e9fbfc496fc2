#pragma once

#include <wheelrail/profiles/profile_file.h>

#include <string>
#include <vector>

namespace wheelrail
{
  /// Whether the points [m], y up, show no flange or no side of a head 14 mm below its top: the crown of a
  /// roller, a groove, a cylinder.
  bool
  is_crown(const std::vector<FilePoint> &points, ProfileKind kind);

  /// The points of a crown [m] from the largest x to the smallest, x mirrored as asked, y turned over for the
  /// reason `turned` (empty: not): a crown may be convex or concave, so that its shape does not show it. Adds
  /// a sentence for everything changed, and for a concave crown; `outwards` is +1 where y points out of the
  /// steel then, else -1.
  std::vector<FilePoint>
  oriented_crown(std::vector<FilePoint>    points,
                 const std::string        &turned,
                 ProfileMirror             mirror,
                 int                       outwards,
                 std::vector<std::string> &notes);
} // namespace wheelrail
