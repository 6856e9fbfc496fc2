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
    FrameProfile rail_heights, wheel_heights; ///< of the head and of the wheel seen along the track, over s
    FrameProfile tread_heights;               ///< of the tread in its own frame; without yaw wheel_heights
  };

  /// How far along the track wheel and rail can overlap when the undeformed wheel is lowered by `approach`
  /// [m]: a parabola z^2 / (2 r) around the lowest place of each slice [m], around the first contact point.
  /// With yaw these places lie one behind the other, those of slices within `beside` [m] of the overlap too,
  /// where the bodies may move the contact to. On the tread no patch is longer.
  Range
  overlap_along(const TouchingProfiles &profiles, double approach, double beside);

  /// Finds the contact (find_contact()) and the heights of both profiles in its frame (FrameProfile). Throws
  /// InputError as these do.
  TouchingProfiles
  touching_profiles(RailProfile            rail,
                    WheelProfile           wheel,
                    const TrackDimensions &track,
                    const WheelsetPose    &pose);
} // namespace wheelrail
