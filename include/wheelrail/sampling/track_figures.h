#pragma once

#include <wheelrail/geometry/frame_profile.h>
#include <wheelrail/output/fields.h>
#include <wheelrail/output/summary.h>

namespace wheelrail
{
  /// Adds what a rail on pads is asked for, from the history, where this has it: the deflection of its foot,
  /// mean over `stretch` of rolled distance [m], and of the whole path the largest force and the largest pull
  /// of a pad.
  void
  add_track_figures(const History &history, const Range &stretch, Summary &summary);
} // namespace wheelrail
