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
    ContactGeometry contact  = find_contact(rail, wheel, track, pose);
    RunningSurfaces surfaces = running_surfaces(rail.head, wheel.tread, contact);
    return {std::move(rail), std::move(wheel), std::move(contact), std::move(surfaces)};
  }


  namespace
  {
    /// How much farther from the lowest line of the wheel irregularities can bring the contact [m]: a slope
    /// moves it by radius times slope, and nowhere does it come farther than where the wheel, lowered by the
    /// depth, reaches.
    double
    farther_contact(const RunningSurfaces &surfaces, const double radius, const double approach)
    {
      double slope = 0, depth = 0;
      for (const Body body : both_bodies)
        for (const Irregularity &one : surfaces[body].irregularities())
          {
            slope += std::min(one.measures.steepest, one.measures.touched);
            depth += one.measures.largest;
          }
      return std::min(radius * slope,
                      half_length_bound(approach + depth, radius) - half_length_bound(approach, radius));
    }
  } // namespace


  Range
  smooth_overlap_along(const TouchingProfiles &profiles, const double approach, const double beside)
  {
    constexpr double       step    = 0.2e-3;
    const ContactGeometry &contact = profiles.contact;
    const FrameProfile    &wheel   = profiles.wheel_heights();
    Range                  lowest;
    for (const Range &part : interpenetration(wheel, profiles.rail_heights(), approach))
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


  Range
  overlap_along(const TouchingProfiles &profiles, const double approach, const double beside)
  {
    const Range  smooth = smooth_overlap_along(profiles, approach, beside);
    const double more   = farther_contact(profiles.surfaces, profiles.contact.rolling_radius, approach);
    return {smooth.s0 - more, smooth.s1 + more};
  }
} // namespace wheelrail
