#pragma once

#include <wheelrail/geometry/irregularity.h>
#include <wheelrail/geometry/touching_profiles.h>
#include <wheelrail/scene/scene.h>

#include <string>
#include <vector>

namespace wheelrail
{
  /// How the surface of two rails beside each other (CrossingSurface) rises over its own section at the start
  /// of the path, along the normal of that section. Arguments as those of rise_of_slices().
  Irregularities
  rise_of_crossing(const Scene              &scene,
                   const TouchingProfiles   &profiles,
                   double                    start,
                   std::vector<std::string> &notes);
} // namespace wheelrail
