#pragma once

#include <wheelrail/model/scene_geometry.h>
#include <wheelrail/scene/scene.h>

#include <ostream>
#include <string>
#include <vector>

namespace wheelrail
{
  /// The shifts that the command `geometry` tabulates when none are asked for: -6 to 6 mm in steps
  /// of 0.5 mm [m].
  std::vector<double>
  default_geometry_shifts();

  /// Prints the rigid contact geometry ("2D-Geo") of the scene's profiles and track: one table per
  /// roll mode over `shifts` [m] (the default ones when empty) with contact point, contact angle,
  /// rolling radius, its difference to the other wheel, lateral radii and second gap minimum, the
  /// shifts at which the contact point jumps, and the details of the scene's own shift.
  ///
  /// `left`: the profiles of the left-hand side, where they differ; null: the same.
  ///
  /// A shift without contact gets a line that says so. Returns the exit code: 0, or 1 when the
  /// scene's own shift has no contact.
  int
  run_geometry_command(const Scene               &scene,
                       const SceneProfiles       &profiles,
                       const std::vector<double> &shifts,
                       std::ostream              &out,
                       const SceneProfiles       *left = nullptr);

  /// Shifts in metres from "-6:6:0.5" (first:last:step) or "-5.5,0,5.5", both in mm.
  /// Throws InputError.
  std::vector<double>
  parse_shifts(const std::string &text);
} // namespace wheelrail
