#include <wheelrail/base/errors.h>
#include <wheelrail/base/quantity.h>
#include <wheelrail/input/entries.h>
#include <wheelrail/model/expected_patch.h>
#include <wheelrail/model/planned_strip.h>

#include <algorithm>
#include <cmath>
#include <vector>

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


  namespace
  {
    /// The stretches of the path on which an irregularity lies under the wheel, `beside` it at most [m].
    std::vector<Range>
    stretches(const RunningSurfaces &surfaces, const double distance, const double beside)
    {
      std::vector<Range> list;
      for (const Body body : both_bodies)
        for (const Irregularity &one : surfaces[body].irregularities())
          {
            const Range part =
              one.endless ? Range{0, distance}
                          : Range{std::max(0., one.begin - beside), std::min(distance, one.end + beside)};
            if (part.s1 >= part.s0)
              list.push_back(part);
          }
      return list;
    }

    /// Heights of the irregularities of both bodies together, at most [m].
    double
    largest_height(const RunningSurfaces &surfaces)
    {
      double largest = 0;
      for (const Body body : both_bodies)
        for (const Irregularity &one : surfaces[body].irregularities())
          largest += one.measures.largest;
      return largest;
    }

    /// Whether an irregularity lies under the wheel all along the path.
    bool
    changes_all_along(const RunningSurfaces &surfaces)
    {
      for (const Body body : both_bodies)
        for (const Irregularity &one : surfaces[body].irregularities())
          if (one.endless)
            return true;
      return false;
    }

    /// The surfaces seen from a place that the wheel has rolled to.
    RunningSurfaces
    surfaces_at(RunningSurfaces surfaces, const double place)
    {
      surfaces.rail.take_irregularities(surfaces.rail, place);
      surfaces.wheel.take_irregularities(surfaces.wheel, place);
      return surfaces;
    }

    /// The values of s where surfaces overlap anywhere within `half` along, once they are brought together
    /// by `approach` from first touch.
    Range
    overlap_across(const RunningSurfaces &surfaces,
                   const Range           &look,
                   const double           half,
                   const double           approach)
    {
      constexpr double    step = 1e-3, step_along = 2e-3; // [m]
      std::vector<double> places, nearest;
      for (double s = look.s0; s <= look.s1; s += step)
        {
          double least = HUGE_VAL;
          for (double z = -half; z <= half; z += step_along)
            least = std::min(least, surfaces.distance(s, z));
          places.push_back(s);
          nearest.push_back(least);
        }
      const double touch = *std::min_element(nearest.begin(), nearest.end());
      Range        overlap{HUGE_VAL, -HUGE_VAL};
      for (std::size_t k = 0; k < places.size(); ++k)
        if (nearest[k] - touch < approach)
          {
            overlap.s0 = std::min(overlap.s0, places[k]);
            overlap.s1 = std::max(overlap.s1, places[k]);
          }
      return overlap;
    }
  } // namespace


  void
  plan_for_irregularities(const SceneGeometry &geometry, SweepSizes &sizes)
  {
    const RunningSurfaces &surfaces = geometry.surfaces;
    const double           height = largest_height(surfaces), radius = geometry.contact.rolling_radius;
    if (!(height > 0))
      return;
    // an impact presses the wheel deeper by no more than what it falls, and four times the load, which goes
    // with the power 3/2, is a rare one
    const double approach = sizes.approach + std::min(height, 1.5 * sizes.approach);
    const double half     = half_length_bound(sizes.approach + height, radius);
    Range        look;
    for (const Range &part :
         interpenetration(geometry.wheel_heights(), geometry.rail_heights(), approach + height))
      look = {std::min(look.s0, part.s0), std::max(look.s1, part.s1)};
    const bool       all_along = changes_all_along(surfaces);
    constexpr double spacing = 2e-3, most = 60; // of places along
    for (const Range &part : stretches(surfaces, sizes.distance, half))
      {
        const int n = static_cast<int>(std::clamp(std::ceil((part.s1 - part.s0) / spacing), 1., most));
        for (int k = 0; k <= n; ++k)
          {
            const double place  = part.s0 + (part.s1 - part.s0) * k / n;
            const Range  across = overlap_across(surfaces_at(surfaces, place), look, half, approach);
            sizes.across = {std::min(sizes.across.s0, across.s0), std::max(sizes.across.s1, across.s1)};
            if (all_along)
              sizes.overlaps.push_back({place, across});
          }
      }
  }
} // namespace wheelrail
