#pragma once

#include <wheelrail/model/scene_geometry.h>

namespace wheelrail
{
  /// One wheel of the wheelset of a scene: that of its side, with profiles and friction of its own.
  Scene
  wheel_of_wheelset(const Scene &scene, bool left);

  /// Profiles of both sides.
  struct WheelsetProfiles
  {
    SceneProfiles right, left;
  };

  /// Reads those of a wheelset, or twice those of the wheel that is modelled. Throws InputError as
  /// read_profiles().
  WheelsetProfiles
  read_wheelset_profiles(const Scene &scene);
} // namespace wheelrail
