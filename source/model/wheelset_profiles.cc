#include <wheelrail/model/wheelset_profiles.h>

#include <cmath>

namespace wheelrail
{
  Scene
  wheel_of_wheelset(const Scene &scene, const bool left)
  {
    Scene wheel      = scene;
    wheel.left_wheel = left;
    if (!left || !scene.both_wheels)
      return wheel;
    if (scene.left_wheel_profile != "as right")
      wheel.wheel_profile = scene.left_wheel_profile;
    if (scene.left_rail_profile != "as right")
      wheel.rail_profile = scene.left_rail_profile;
    if (std::isfinite(scene.left_friction))
      wheel.friction = wheel.friction.with_rest(scene.left_friction);
    return wheel;
  }


  WheelsetProfiles
  read_wheelset_profiles(const Scene &scene)
  {
    const Scene      right = wheel_of_wheelset(scene, false), left = wheel_of_wheelset(scene, true);
    WheelsetProfiles profiles{read_profiles(right), {}};
    const bool alike = left.wheel_profile == right.wheel_profile && left.rail_profile == right.rail_profile;
    profiles.left    = alike ? profiles.right : read_profiles(left);
    return profiles;
  }
} // namespace wheelrail
