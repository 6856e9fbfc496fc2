#include <wheelrail/bodies/body_contact.h>

#include <algorithm>
#include <cmath>

// Distance, angles and rolling radius of each row of elements of the unfolded rail (doc/theory/bodies.md,
// Contact).

namespace wheelrail
{
  BodyContact::Row
  BodyContact::row_at(const double y) const
  {
    const Curve     &head = geometry_.rail.head, &outline = geometry_.contact.outline.curve;
    const Placement &rail = geometry_.contact.rail, &wheel = geometry_.contact.wheel;
    Row              row;
    // 1. Place and angle on the rail: arc y from the first contact point
    const double t         = head.advance(first_, y);
    row.rail_arc           = first_arc_ + y;
    const CurvePoint point = head.at(t);
    row.place              = rail.to_track(point.position);
    const Point2 ahead     = rail.to_track(point.position + point.tangent) - row.place;
    row.angle              = std::atan2(ahead.y, ahead.x);
    // of the undeformed rail, out of it; `aside` is v along e_s = (n_y, -n_x)
    const Point2    normal{-std::sin(row.angle), std::cos(row.angle)};
    const RowMotion motion = motion_at(y);
    const Point2    aside  = motion.shift * Point2{normal.y, -normal.x};
    // angle + phi_rail of (5)
    row.angle += motion.turn;
    // the rail's normal cuts the tangent of the wheel at its closest point
    // steel that meets row s lay at s - v before (6)
    // 2. The wheel's steel that faces it: s - v on its profile; distance along the rail's normal
    const double     tw      = outline.closest(wheel.to_section(row.place - aside));
    const CurvePoint closest = outline.at(tw);
    const Point2     foot    = wheel.to_track(closest.position),
                 tangent     = wheel.to_track(closest.position + closest.tangent) - foot;
    // place + d normal lies on the tangent through foot + aside: cross(tangent, place + d normal - foot -
    // aside) = 0
    row.distance = cross(tangent, foot + aside - row.place) / cross(tangent, normal);
    // 3. Arc on the tread, slice of the wheel, rolling radius and angles there
    row.wheel_arc  = geometry_.wheel.tread.length(0, geometry_.contact.outline.on_tread(tw));
    const double s = geometry_.contact.frame.to_frame(foot).x;
    row.touches    = t > 0 && t < head.parameter_end() && tw > 0 && tw < outline.parameter_end() &&
                  s > sections_.s_min() && s < sections_.s_max() && std::cos(row.angle) > 0.05;
    if (!row.touches)
      return row;
    row.slice = sections_.slice(s);
    row.slice.wheel_angle += motion.rim_turn;
    row.slice.wheel_tangent += motion.rim_turn;
    row.s = s;
    // distances of the sections lie along the normal of the first contact point
    // d(x) along another normal: the tangent plane of the wheel at the angle b cuts a normal at the angle a
    // at d cos(b - a_0)/cos(b - a), a_0 that of the frame
    row.along_normal = std::cos(row.slice.wheel_tangent - geometry_.contact.frame.angle) /
                       std::cos(row.slice.wheel_tangent - row.angle);
    return row;
  }


  void
  BodyContact::lay_grid(const double element, const double reached)
  {
    // 1. Extent across: where the rigid surfaces are closer than `reached`
    constexpr double longest = 0.04; // of a stretch without contact that may lie between two patches [m]
    // the last place where they are, with up to 40 mm between two patches
    const auto end = [&](const double step) {
      double last = 0;
      for (double y = 0; std::abs(y - last) < longest; y += step)
        {
          const Row row = row_at(y);
          if (!row.touches)
            break;
          if (row.distance < reached * std::cos(row.angle))
            last = y;
        }
      return last;
    };
    const double coarse = std::max(element, 0.5e-3), low = end(-coarse), high = end(coarse);
    // 2. Extent along: with yaw the overlap lies ahead of or behind the axle, by as much as slices say
    double back = 0, front = 0;
    for (const double y : {low, 0., high})
      {
        const double along = row_at(y).slice.along;
        back               = std::min(back, along);
        front              = std::max(front, along);
      }
    // half length of the interpenetration, x^2/(2 r) = approach; `reached` is 1.5 times the approach
    const double half = std::sqrt(2 * geometry_.contact.rolling_radius * reached / 1.5);
    const int    n0   = int(std::ceil((half - back) / element)) + 2,
              n1 = int(std::ceil((half + front) / element)) + 2, y0 = int(std::floor(low / element)) - 2,
              y1  = int(std::ceil(high / element)) + 2;
    problem_.grid = {n0 + n1 + 1, y1 - y0 + 1, element, element, -n0 * element, y0 * element};
    // 3. Rows, not yet moved, and bodies for them
    rows_.clear();
    motions_.clear();
    for (int j = 0; j < problem_.grid.my; ++j)
      rows_.push_back(row_at(problem_.grid.y(j)));
    set_bodies();
    constexpr double far = 0.1; // farther than any approach: where there is no surface [m]
    problem_.undeformed_distance.assign(problem_.grid.size(), far);
    problem_.normal_cosine.assign(problem_.grid.size(), 1);
    for (int j = 0; j < problem_.grid.my; ++j)
      if (const Row &row = rows_[j]; row.touches)
        {
          const double lowest = sections_.distance(row.s), cosine = std::cos(row.angle);
          // gap along the normal: d(s), and growth along it, n . growth; then x^2/2 times the curvature
          // (doc/theory/bodies.md, Contact)
          const double own = row.distance + growth_[j].y * cosine - growth_[j].x * std::sin(row.angle);
          for (int i = 0; i < problem_.grid.mx; ++i)
            {
              const int e = i + problem_.grid.mx * j;
              problem_.undeformed_distance[e] =
                own + row.along_normal * (sections_.distance(row.s, problem_.grid.x(i)) - lowest);
              problem_.normal_cosine[e] = cosine;
            }
        }
    set_slip();
    solution_ = {};
    rise_.clear();
  }
} // namespace wheelrail
