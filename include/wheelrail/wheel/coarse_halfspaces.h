#pragma once

#include <wheelrail/scene/scene.h>

#include <algorithm>

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
} // namespace wheelrail
