#pragma once

#include <wheelrail/geometry/contact_geometry.h>
#include <wheelrail/geometry/frame_profile.h>
#include <wheelrail/geometry/profiles.h>
#include <wheelrail/geometry/track.h>

namespace wheelrail
{
  /// Rail and wheel in their first contact: the profiles, where 2D-Geo puts them, and the running surfaces
  /// around the contact point.
  struct TouchingProfiles
  {
    RailProfile     rail;
    WheelProfile    wheel;
    ContactGeometry contact;
    FrameProfile    rail_heights, wheel_heights; ///< of the head and of the tread over s
  };

  /// Finds the contact (find_contact()) and the heights of both profiles in its frame (FrameProfile). Throws
  /// InputError as these do.
  TouchingProfiles
  touching_profiles(RailProfile            rail,
                    WheelProfile           wheel,
                    const TrackDimensions &track,
                    const WheelsetPose    &pose);
} // namespace wheelrail
