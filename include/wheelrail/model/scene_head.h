#pragma once

#include <wheelrail/scene/scene.h>

#include <string>
#include <vector>

namespace wheelrail
{
  /// A line of the head above the results of a scene.
  struct HeadLine
  {
    std::string name; ///< "drive"
    std::string text; ///< "driving, traction coefficient 0.25 of friction 0.5"
  };

  /// What the bodies of a scene are taken as.
  enum class HeadOf
  {
    run,       ///< finite elements: their steel and their cells
    halfspaces ///< their elements
  };

  /// What is computed, in words of the field: profiles, inclination, load, speed, pose, drive, friction,
  /// steel and cells. `wheel_load`: static [N], or 0 where none is known, as between rollers. Of a scene that
  /// follows a motion the values at its start.
  std::vector<HeadLine>
  scene_head(const Scene &scene, double wheel_load, HeadOf of);
} // namespace wheelrail
