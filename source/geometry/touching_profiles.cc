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
  overlap_along(const TouchingProfiles &profiles, const double approach, const double beside)
  {
    constexpr double       step    = 0.2e-3;
    const ContactGeometry &contact = profiles.contact;
    const FrameProfile    &wheel   = profiles.wheel_heights;
    Range                  lowest;
    for (const Range &part : interpenetration(wheel, profiles.rail_heights, approach))
      for (double s = std::max(part.s0 - beside, wheel.s_min());
           s <= std::min(part.s1 + beside, wheel.s_max());
           s += step)
        {
          const FrameProfile::Value height = wheel.at(s);
          const Point2              place  = contact.frame.to_track({s, height.n});
          const double              along =
            contact.axis.surface_point(place, contact.frame.angle + std::atan(height.slope)).along -
            contact.along;
          lowest.s0 = std::min(lowest.s0, along);
          lowest.s1 = std::max(lowest.s1, along);
        }
    const double half = half_length_bound(approach, contact.rolling_radius);
    return {lowest.s0 - half, lowest.s1 + half};
  }
} // namespace wheelrail
