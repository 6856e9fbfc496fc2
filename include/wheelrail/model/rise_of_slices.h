#pragma once

#include <wheelrail/geometry/irregularity.h>
#include <wheelrail/geometry/touching_profiles.h>
#include <wheelrail/scene/scene.h>

#include <string>
#include <vector>

namespace wheelrail
{
  /// How the surface of the slices rises over the rail of read_sliced_rail(), along its normal: the distance
  /// of each section from it less that of the section which it has. `start` of the wheel [m] ahead of where
  /// the path begins. Nothing where all sections are alike within 1 nm.
  ///
  /// A second rail lies behind the first: the surface goes over to it in the gap, which is one more
  /// irregularity, too deep to carry; steel goes through below. Of rails beside each other see
  /// rise_of_crossing(). Throws InputError where sections have no part in common with the first 5 mm on both
  /// sides of the contact.
  Irregularities
  rise_of_slices(const Scene              &scene,
                 const TouchingProfiles   &profiles,
                 double                    start,
                 std::vector<std::string> &notes);
} // namespace wheelrail
