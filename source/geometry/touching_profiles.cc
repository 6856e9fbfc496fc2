#include <wheelrail/geometry/running_surfaces.h>
#include <wheelrail/geometry/touching_profiles.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace wheelrail
{
  TouchingProfiles
  touching_profiles(RailProfile            rail,
                    WheelProfile           wheel,
                    const TrackDimensions &track,
                    const WheelsetPose    &pose)
  {
    ContactGeometry contact = find_contact(rail, wheel, track, pose);
    FrameProfile    rail_heights(rail.head, contact.rail, contact.frame);
    FrameProfile    wheel_heights(contact.outline.curve, contact.wheel, contact.frame);
    FrameProfile    tread_heights(wheel.tread, contact.wheel, contact.tread_frame);
    return {std::move(rail),
            std::move(wheel),
            std::move(contact),
            std::move(rail_heights),
            std::move(wheel_heights),
            std::move(tread_heights)};
  }


  Range
  overlap_along(const TouchingProfiles &profiles, const double approach)
  {
    constexpr double       step    = 0.2e-3;
    const ContactGeometry &contact = profiles.contact;
    const double           half    = half_length_bound(approach, contact.rolling_radius);
    Range                  along{-half, half};
    for (const Range &part : interpenetration(profiles.wheel_heights, profiles.rail_heights, approach))
      for (double s = part.s0; s <= part.s1; s += step)
        {
          const FrameProfile::Value wheel  = profiles.wheel_heights.at(s);
          const double              lowest = contact.axis
                                  .surface_point(contact.frame.to_track({s, wheel.n}),
                                                 contact.frame.angle + std::atan(wheel.slope))
                                  .along -
                                contact.along;
          const double gap =
            std::clamp(undeformed_distance(profiles.wheel_heights, profiles.rail_heights, s), 0., approach);
          const double reach = half_length_bound(approach - gap, contact.rolling_radius);
          along.s0           = std::min(along.s0, lowest - reach);
          along.s1           = std::max(along.s1, lowest + reach);
        }
    return along;
  }
} // namespace wheelrail
