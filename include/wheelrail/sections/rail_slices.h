#pragma once

#include <wheelrail/scene/scene.h>
#include <wheelrail/sections/sections_surface.h>
#include <wheelrail/sections/slices_file.h>

#include <string>
#include <vector>

namespace wheelrail
{
  /// The slices of a rail, turned as the scene asks. Throws InputError.
  Slices
  turned_slices(const ProfileSettings &scene, const std::string &path);

  /// The slice nearest to where the path begins.
  const Slices::Slice &
  slice_of_start(const ProfileSettings &scene, const Slices &slices);

  /// The least distance of two slices [m].
  double
  least_distance(const std::vector<Slices::Slice> &slices);

  /// Steps along for such a distance: four places between two slices leave nothing of the splines out [m].
  double
  step_along(double least);

  /// Whether the second rail stands beside the first, as a nose beside its wing.
  bool
  rails_beside(const ProfileSettings &scene, const Slices &slices);

  /// The gap between two rails one behind the other along the slices [m]; infinitely far for one rail, and
  /// for rails beside each other. Throws InputError for a path that leaves the slices.
  Range
  gap_of_rails(const Scene &scene, const Slices &slices);

  /// The surface of a rail that an entry of a scene gives by slices, in `placement`; see SectionsSurface.
  /// Jumps of its arc length are told in `notes`. Throws InputError that names the entry.
  SectionsSurface
  read_rail_slices(const ProfileSettings    &scene,
                   const std::string        &entry,
                   const std::string        &path,
                   const Placement          &placement,
                   std::vector<std::string> &notes);

  /// The same with each slice off by one more draw of their noise [m].
  SectionsSurface
  drawn_rail_slices(const ProfileSettings &scene,
                    const SectionsSurface &rail,
                    const Placement       &placement,
                    unsigned int           draw);
} // namespace wheelrail
