#pragma once

#include <wheelrail/model/scene_geometry.h>
#include <wheelrail/scene/scene.h>

#include <ostream>
#include <string>

namespace wheelrail
{
  /// Writes what the picture of a scene's profiles shows into `<name>.csv` and draws `<name>.png`
  /// from it (source/report/profile_picture.py): both profiles in the track plane at the scene's
  /// own shift, the contact point, further points that touch under load, and the undeformed distance along
  /// the common tangent. Tells the name of the picture.
  ///
  /// Throws RunError when a file cannot be written or the script fails.
  void
  draw_profiles(const ProfileSettings &scene,
                const SceneGeometry   &geometry,
                const std::string     &name,
                std::ostream          &out);
} // namespace wheelrail
