#pragma once

#include <wheelrail/profiles/profile_file.h>

#include <string>

namespace wheelrail
{
  /// Profiles of wheel and rail, on both sides, as in subsection Profiles.
  struct ProfileSettings
  {
    std::string        wheel_profile      = "S1002"; ///< standard profile or file
    std::string        rail_profile       = "54E1";
    std::string        left_wheel_profile = "as right"; ///< of a whole wheelset
    std::string        left_rail_profile  = "as right";
    ProfileFileOptions wheel_file{ProfileKind::wheel}; ///< how files are read
    WheelOrigin        wheel_origin = WheelOrigin::automatic;
    ProfileFileOptions rail_file{ProfileKind::rail};
    std::string        rail_body   = "auto"; ///< standard rail below a measured head
    std::string        second_rail = "none"; ///< file of slices of another rail under the same wheel, or none
    double             rail_place  = 0;      ///< along rails by slices, where the path begins [m]

    /// Whether the section of the rail changes along the track.
    bool
    rail_by_slices() const
    {
      return is_slices_file(rail_profile);
    }
  };
} // namespace wheelrail
