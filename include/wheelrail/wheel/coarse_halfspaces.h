#pragma once

#include <wheelrail/scene/scene.h>

#include <algorithm>
#include <limits>

namespace wheelrail
{
  /// The scene by half-spaces on elements of at least 0.8 mm: enough for the search of a pose and for shares
  /// of the peak pressure, which are solved many times.
  inline Scene
  coarse_halfspaces(Scene scene)
  {
    scene.halfspace_element_size = std::max(0.8e-3, scene.halfspace_element_size);
    scene.halfspace_bodies       = ContactBodies::half_spaces;
    return scene;
  }

  /// The scene without what half-spaces may be given and a run does not have.
  inline Scene
  scene_of_run(Scene scene)
  {
    scene.halfspace_memory_length   = 0;
    scene.halfspace_layer_thickness = 0;
    scene.halfspace_given_spin      = std::numeric_limits<double>::infinity();
    scene.halfspace_lateral         = 0;
    scene.halfspace_inclination     = 0;
    scene.halfspace_distance        = "profiles";
    return scene;
  }
} // namespace wheelrail
