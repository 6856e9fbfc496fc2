#pragma once

#include <wheelrail/geometry/touching_profiles.h>
#include <wheelrail/geometry/track.h>
#include <wheelrail/output/summary.h>

#include <string>

namespace wheelrail
{
  /// Writes sections.json, with which pages show where on the rail a result lies: rail head and
  /// wheel tread before they deform, as the contact of 2D-Geo puts them in the track plane (X to the track
  /// centre from the running circle, Y up from the top of the rail), the contact point with the angle of the
  /// axis s, the rail's own axis and the gauge face, all in m and rad. Throws RunError when it cannot be
  /// written.
  void
  write_sections(const TouchingProfiles &profiles, const TrackDimensions &track, const std::string &path);

  /// Sets the figures of the place of the middle of the patch on the rail head.
  void
  set_patch_place(const HeadPlace &place, Summary &summary);
} // namespace wheelrail
