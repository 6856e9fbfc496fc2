#pragma once

#include <wheelrail/base/body.h>
#include <wheelrail/geometry/irregularity.h>
#include <wheelrail/model/scene_geometry.h>
#include <wheelrail/scene/scene.h>

#include <memory>
#include <string>
#include <vector>

namespace wheelrail
{
  /// Heights up to this one are taken by the contact as offsets of the gap, larger ones move the mesh [m]. On
  /// a wheel an offset leaves the surface that slides where it was, with the speed of the whole radius: a
  /// slip of height over radius, which 1e-4 and more of creepage would feel. So only heights of nothing stay
  /// offsets there.
  constexpr PerBody<double> deepest_offset = {0.05e-3, 1e-6};

  /// The irregularities of a scene on both bodies, whose profiles are in touch. Reads their files, and
  /// tells in `notes` what of these is left out. Throws InputError that names the entry.
  PerBody<std::shared_ptr<const Irregularities>>
  make_irregularities(const Scene &scene, const TouchingProfiles &profiles, std::vector<std::string> &notes);

  /// Puts them on the surfaces of the profiles.
  void
  add_irregularities(const Scene &scene, SceneGeometry &profiles);

  /// Its name in the input: "Irregularity 3".
  std::string
  irregularity_name(int number);
} // namespace wheelrail
