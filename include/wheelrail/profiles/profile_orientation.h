#pragma once

#include <wheelrail/profiles/profile_file.h>

#include <string>
#include <vector>

namespace wheelrail
{
  /// The points of a wheel profile [m] with x positive to the field side, y up (the flange hangs
  /// down), running from the field side to the flange back, without the face of the rim more than 15 mm above
  /// the tread. Turned (unless `turn` says whether) and mirrored by the place of the flange, whatever the
  /// spacing of the points; `mirror` must agree with it. Adds a sentence for everything changed.
  ///
  /// Throws InputError for what is no wheel: no flange 15 mm to 45 mm deep, a tread narrower than
  /// 60 mm.
  std::vector<FilePoint>
  oriented_wheel(std::vector<FilePoint>    points,
                 const std::string        &file,
                 ProfileMirror             mirror,
                 ProfileMirror             turn,
                 std::vector<std::string> &notes);

  /// The points of a rail head [m] with x positive to the field side, y up, running from the field
  /// side to the gauge side, down to at most 35 mm below the top. Which side is the gauge side
  /// cannot be seen: with ProfileMirror::automatic x is mirrored when `gauge_right` says that it
  /// grows to the gauge side.
  ///
  /// Throws InputError for what is no rail head: narrower than 40 mm or wider than 95 mm, with no
  /// side that reaches 5 mm below the top.
  std::vector<FilePoint>
  oriented_rail(std::vector<FilePoint>    points,
                const std::string        &file,
                ProfileMirror             mirror,
                ProfileMirror             turn,
                bool                      gauge_right,
                std::vector<std::string> &notes);

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
