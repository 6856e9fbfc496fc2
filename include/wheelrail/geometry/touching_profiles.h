#pragma once

#include <wheelrail/geometry/contact_geometry.h>
#include <wheelrail/geometry/profiles.h>
#include <wheelrail/geometry/running_surfaces.h>
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
    RunningSurfaces surfaces; ///< in the frame of the contact point

    /// Smooth heights of the head, and of the wheel seen along the track, over s.
    const FrameProfile &
    rail_heights() const
    {
      return surfaces.rail.profile();
    }
    const FrameProfile &
    wheel_heights() const
    {
      return surfaces.outline.profile();
    }
  };

  /// How far along the track wheel and rail can overlap when the undeformed smooth wheel is lowered by
  /// `approach` [m]: half a chord of the rolling circle around the lowest place of each slice [m], around the
  /// first contact point. With yaw these places lie one behind the other, those of slices within `beside` [m]
  /// of the overlap too, where the bodies may move the contact to. On the tread no patch is longer.
  Range
  smooth_overlap_along(const TouchingProfiles &profiles, double approach, double beside);

  /// The same with what irregularities add to it: a slope moves the contact by radius times slope.
  Range
  overlap_along(const TouchingProfiles &profiles, double approach, double beside);

  /// Finds the contact (find_contact()) and the surfaces there (running_surfaces()). Throws InputError as
  /// these do.
  TouchingProfiles
  touching_profiles(RailProfile            rail,
                    WheelProfile           wheel,
                    const TrackDimensions &track,
                    const WheelsetPose    &pose);
} // namespace wheelrail
