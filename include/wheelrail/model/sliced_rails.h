#pragma once

#include <wheelrail/geometry/irregularity.h>
#include <wheelrail/geometry/touching_profiles.h>
#include <wheelrail/model/scene_geometry.h>
#include <wheelrail/scene/scene.h>

#include <string>
#include <vector>

namespace wheelrail
{
  // What slices along the track and around the wheel add to a scene: the room sections.

  /// The rail for a mesh: that of the slice nearest to where the path begins, on its standard body. Throws
  /// InputError that names the entry.
  void
  read_sliced_rail(const Scene &scene, SceneProfiles &profiles);

  /// Whether the second rail stands beside the first, as a nose beside its wing.
  bool
  is_crossing(const ProfileSettings &scene);

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

  /// The irregularity that a file of slices has over the profiles, `place` along from the first contact [m];
  /// `radius` of the circle on which the arcs of a wheel count [m].
  Irregularity
  irregularity_of_slices(const ProfileSettings    &scene,
                         const IrregularityData   &data,
                         const TouchingProfiles   &profiles,
                         double                    place,
                         double                    radius,
                         std::vector<std::string> &notes);
} // namespace wheelrail
