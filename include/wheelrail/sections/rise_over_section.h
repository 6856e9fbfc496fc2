#pragma once

#include <wheelrail/geometry/irregularity.h>
#include <wheelrail/geometry/touching_profiles.h>
#include <wheelrail/profiles/height_grid.h>
#include <wheelrail/scene/scene.h>

#include <string>
#include <vector>

namespace wheelrail
{
  /// A point of the smooth rail with its tangent and outward normal, in the section.
  struct Foot
  {
    Point2 position, tangent, normal;
  };

  /// The rail around the contact, across each 0.5 mm, where it is no steeper than 4 against the contact.
  std::vector<Foot>
  feet_of(const TouchingProfiles &profiles);

  /// 0 up to `from`, 1 from `to` on, smoothly between them.
  double
  passing_over(double at, double from, double to);

  /// The irregularity of rises over the section of a mesh, whose rail begins at `begin` of the slices,
  /// `start` behind the first contact of the wheel [m].
  Irregularity
  rise_irregularity(const HeightGrid &grid, double begin, double start);

  /// How the surface of two rails beside each other (CrossingSurface) rises over its own section at the start
  /// of the path, along the normal of that section. Arguments as those of rise_of_slices().
  Irregularities
  rise_of_crossing(const Scene              &scene,
                   const TouchingProfiles   &profiles,
                   double                    start,
                   std::vector<std::string> &notes);
} // namespace wheelrail
