#pragma once

#include <wheelrail/scene/scene.h>

#include <ostream>
#include <string>

namespace wheelrail
{
  /// Carries out `geometry --places`: where the rigid wheel touches rails by slices at places along them, its
  /// height, rolling radius and angles, as a table on the screen. `places` as the option has them. Throws
  /// InputError for scenes without such rails and for places that these do not have.
  int
  print_touching_places(const Scene &scene, const std::string &places, std::ostream &out);

  /// Carries out `halfspace --places` on rails by slices: the wheel rolls under its load at each place, with
  /// a patch on each part that it touches; a table on the screen, places.csv with a row for each patch, and
  /// sections.csv with the surfaces in the folder of the command halfspace; when `draws`, a picture of them.
  /// The wheel turns at velocity over nominal radius, faster by Wheelset/Creepage where that is prescribed.
  /// Returns 0, or 2 when a place could not be solved.
  int
  run_sections_command(const Scene &scene, const std::string &places, bool draws, std::ostream &out);
} // namespace wheelrail
