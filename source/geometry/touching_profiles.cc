#include <wheelrail/geometry/touching_profiles.h>

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
    return {std::move(rail),
            std::move(wheel),
            std::move(contact),
            std::move(rail_heights),
            std::move(wheel_heights)};
  }
} // namespace wheelrail
