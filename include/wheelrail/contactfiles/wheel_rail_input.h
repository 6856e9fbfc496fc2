#pragma once

#include <wheelrail/model/scene_geometry.h>
#include <wheelrail/scene/scene.h>

#include <string>

namespace wheelrail
{
  /// The files of one case for the wheel-rail module of the program CONTACT.
  struct WheelRailInput
  {
    std::string input, rail, wheel; ///< contents of the input file and of the two profile files
  };

  /// The scene's contact as input of CONTACT's wheel-rail module (open version, revision 2707; right wheel,
  /// mm, N, rad, s): track, profiles as points every 0.25 mm along the outline (y to the field side, z down;
  /// rail from the gauge side, wheel from the field side, as CONTACT wants them), wheelset position,
  /// vertical load [N], longitudinal force or pitch rate, element size of the scene. CONTACT's y points to
  /// the right, so that a shift of the flange to the rail is positive there and negative here. The profile
  /// files are named by `rail_file` and `wheel_file`. Throws InputError for friction that depends on speed, a
  /// wheelset that rolls, and a distance that is not that of the profiles.
  WheelRailInput
  wheel_rail_input(const Scene         &scene,
                   const SceneGeometry &geometry,
                   double               vertical_load,
                   const std::string   &rail_file,
                   const std::string   &wheel_file);
} // namespace wheelrail
