#include <wheelrail/base/errors.h>
#include <wheelrail/base/quantity.h>
#include <wheelrail/input/entries.h>
#include <wheelrail/model/expected_patch.h>
#include <wheelrail/model/planned_strip.h>

#include <algorithm>
#include <cmath>

namespace wheelrail
{
  namespace
  {
    /// The frame on the rail head at the place x of its section [m]; throws where it has none.
    ContactFrame
    frame_on_head(const TouchingProfiles &profiles, const double x, const Scene &scene)
    {
      const Curve &head = profiles.rail.head;
      const auto   t    = head.roots([x](const Point2 &p) { return p.x - x; }, 0, head.parameter_end());
      if (t.empty())
        throw InputError(
          entry_text(scene, "Mesh", "Planned strip") + ": the running surface of the rail reaches from " +
          in_mm(head.at(head.parameter_end()).position.x) + " to " + in_mm(head.at(0).position.x));
      const CurvePoint point  = head.at(t.front());
      const Placement &placed = profiles.contact.rail;
      const Point2     origin = placed.to_track(point.position),
                   along      = placed.to_track(point.position + point.tangent) - origin;
      return {origin, std::atan2(along.y, along.x)};
    }
  } // namespace


  PlannedStrip
  plan_strip(const Scene &scene, const SceneGeometry &geometry)
  {
    const std::vector<double> &x     = scene.planned_strip;
    const ContactFrame         frame = frame_on_head(geometry, 0.5 * (x[0] + x[1]), scene);
    PlannedStrip               planned{geometry, {}};
    planned.s                  = {frame.to_frame(frame_on_head(geometry, x[1], scene).origin).x,
                                  frame.to_frame(frame_on_head(geometry, x[0], scene).origin).x};
    TouchingProfiles &profiles = planned.profiles;
    ContactGeometry  &contact  = profiles.contact;
    contact.frame              = frame;
    contact.tread_frame        = frame;
    contact.rolling_radius     = scene.track.nominal_radius;
    profiles.surfaces          = running_surfaces(profiles.rail.head, profiles.wheel.tread, contact);
    profiles.surfaces.rail.take_irregularities(geometry.surfaces.rail);
    profiles.surfaces.wheel.take_irregularities(geometry.surfaces.wheel);
    return planned;
  }


  std::vector<double>
  strip_of_patch(const Scene &scene, const SceneGeometry &geometry, const double load)
  {
    Scene loaded                    = scene;
    loaded.wheel_load               = load;
    const ContactGeometry &contact  = geometry.contact;
    const double           approach = expected_approach(loaded, contact.rolling_radius);
    double                 low = contact.rail_x, high = contact.rail_x;
    for (const Range &part : interpenetration(geometry.wheel_heights(), geometry.rail_heights(), approach))
      for (const double s : {part.s0 - scene.fine_margin, part.s1 + scene.fine_margin})
        {
          const double inside =
            std::clamp(s, geometry.rail_heights().s_min(), geometry.rail_heights().s_max());
          const Point2 place =
            contact.rail.to_section(contact.frame.to_track({inside, geometry.rail_heights().at(inside).n}));
          low  = std::min(low, place.x);
          high = std::max(high, place.x);
        }
    return {low, high};
  }
} // namespace wheelrail
