#pragma once

#include <wheelrail/model/scene_geometry.h>
#include <wheelrail/scene/scene.h>
#include <wheelrail/wheel/irregular_places.h>

#include <ostream>

namespace wheelrail
{
  /// Carries out `halfspace --places` and `--pitch`: the contact of a wheel at rest at places along irregular
  /// surfaces, as a table on the screen, as places.csv with the patches in places.h5 and, when `draws`, as
  /// pictures/places.png in the folder of the command halfspace. Returns 0, or 2 when a place could not be
  /// solved.
  int
  run_places_command(const Scene           &scene,
                     const SceneGeometry   &geometry,
                     const IrregularPlaces &places,
                     bool                   draws,
                     std::ostream          &out);
} // namespace wheelrail
