#include <wheelrail/geometry/running_surfaces.h>

#include <cmath>

// Height of the turning wheel over a place (s, z) of the rail: on the surface of revolution itself, in its
// position with yaw and offsets (doc/theory/geometry.md). A parabola in its place changes the main scene by
// 2e-5.

namespace wheelrail
{
  double
  half_length_bound(const double approach, const double rolling_radius)
  {
    // half a chord of the rolling circle, sqrt((2 r - d) d)
    return std::sqrt((2 * rolling_radius - approach) * approach);
  }


  void
  RunningSurfaces::tabulate(const double s0, const double s1)
  {
    rail.tabulate(s0, s1);
    wheel.tabulate(s0, s1);
    outline.tabulate(s0, s1);
  }


  double
  RunningSurfaces::wheel_height(const double s, const double z) const
  {
    constexpr double enough = 1e-14; // [m]
    const auto       inside = [&](const double n) {
      const Point2                place = frame.to_track({s, n});
      const RunningSurface::Place there = wheel.place({place.x, place.y, z});
      return there.n - wheel.at(there.s, there.along).n;
    };
    // n moves a point through the wheel's surface nearly along its normal: the first secant has slope one
    double n     = outline.at(s).n + z * z / (2 * rolling_radius);
    double value = inside(n), rise = 1;
    for (int k = 0; k < 20 && std::abs(value) > enough; ++k)
      {
        // secant steps: rise is d(inside)/dn
        const double step = -value / rise, next = inside(n + step);
        n += step;
        if (std::abs(next) >= std::abs(value))
          break; // round-off, or a kink
        rise  = (next - value) / step;
        value = next;
      }
    return n;
  }


  Vector3
  RunningSurfaces::rolling(const double s, const double z) const
  {
    const Point2 place = frame.to_track({s, outline.at(s).n});
    return pose().rolling({place.x, place.y, z});
  }


  RunningSurfaces
  running_surfaces(const Curve &head, const Curve &tread, const ContactGeometry &contact)
  {
    return {contact.frame,
            {FrameProfile(head, contact.rail, contact.frame), contact.frame, contact.rail},
            {FrameProfile(tread, contact.wheel, contact.tread_frame),
             contact.tread_frame,
             contact.pose,
             contact.rolling_radius},
            SectionHeights(FrameProfile(contact.outline.curve, contact.wheel, contact.frame)),
            contact.rolling_radius,
            contact.forward_radius};
  }
} // namespace wheelrail
