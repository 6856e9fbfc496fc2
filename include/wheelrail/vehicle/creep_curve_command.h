#pragma once

#include <wheelrail/model/scene_geometry.h>
#include <wheelrail/scene/scene.h>
#include <wheelrail/vehicle/creep_curve.h>

#include <ostream>
#include <string>

namespace wheelrail
{
  /// Carries out `halfspace --creep-curve`: forces over creepages or spin, as a table on the screen, as
  /// creep_curve.csv and, when `draws`, as pictures/creep_curve.png in the folder of the command halfspace.
  /// `beside`: a file of points to draw beside it (read_curve_file()), or empty. `geometry` may be null
  /// unless needs_profiles(). Returns 0, or 2 when a point could not be solved.
  int
  run_creep_curve_command(const Scene         &scene,
                          const SceneGeometry *geometry,
                          const CreepCurve    &curve,
                          const std::string   &beside,
                          bool                 draws,
                          std::ostream        &out);
} // namespace wheelrail
