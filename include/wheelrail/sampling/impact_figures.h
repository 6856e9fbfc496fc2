#pragma once

#include <wheelrail/geometry/frame_profile.h>
#include <wheelrail/output/fields.h>
#include <wheelrail/output/summary.h>

namespace wheelrail
{
  /// The distance after which the vertical force was largest [m]; the history has rows.
  double
  place_of_largest_force(const History &history);

  /// Adds what a run over irregular surfaces is asked for, from its history: largest and least vertical force
  /// of the wheel with their places, the largest over the static `load` [N] (impact factor), the length
  /// rolled without contact (a vertical force below a thousandth of the load), and the largest accelerations
  /// of the axle box upwards and downwards where the history has them.
  void
  add_impact_figures(const History &history, double load, Summary &summary);

  /// Adds what a rail on pads is asked for, from the history, where this has it: the deflection of its foot,
  /// mean over `stretch` of rolled distance [m], and of the whole path the largest force and the largest pull
  /// of a pad.
  void
  add_track_figures(const History &history, const Range &stretch, Summary &summary);
} // namespace wheelrail
