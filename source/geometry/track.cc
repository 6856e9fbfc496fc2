#include <wheelrail/base/errors.h>
#include <wheelrail/base/quantity.h>
#include <wheelrail/geometry/track.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace wheelrail
{
  double
  running_circle_distance(const TrackDimensions &track)
  {
    return 0.5 * track.flange_back_distance + 0.070;
  }


  WheelsetPose
  mirrored(const WheelsetPose &pose)
  {
    return {-pose.lateral_shift, pose.roll, -pose.roll_angle, -pose.yaw};
  }


  Placement
  place_rail(const RailProfile &rail, const TrackDimensions &track)
  {
    // Turned clockwise, the top of the rail leans to +X, the track centre.
    Placement placement;
    placement.angle = -std::atan(track.inclination);

    // The highest point has a tangent along X.
    const Curve &head = rail.head;
    const double c = std::cos(placement.angle), s = std::sin(placement.angle);
    double       top = -std::numeric_limits<double>::max();
    for (const Segment &g : head.segments())
      {
        top = std::max({top, placement.to_track(g.start).y, placement.to_track(g.end).y});
        if (g.kind == Segment::Kind::line)
          continue;
        double     t0 = 0, t1 = 1;
        const auto climb = [&](const double t) {
          const Point2 tangent = point_on(g, t).tangent;
          return -s * tangent.x + c * tangent.y;
        };
        if (!(climb(t0) > 0 && climb(t1) < 0))
          continue;
        for (double t = 0.5; t > t0 && t < t1; t = 0.5 * (t0 + t1))
          (climb(t) > 0 ? t0 : t1) = t;
        top = std::max(top, placement.to_track(position_on(g, t0)).y);
      }

    if (rail.placed)
      {
        placement.origin = {0, -top};
        return placement;
      }
    const auto above = [&](const Point2 &p) { return placement.to_track(p).y - (top - track.gauge_height); };
    double     gauge_side = -std::numeric_limits<double>::max();
    for (const double t : head.roots(above, 0, head.parameter_end()))
      gauge_side = std::max(gauge_side, placement.to_track(head.at(t).position).x);
    if (gauge_side == -std::numeric_limits<double>::max())
      throw InputError("The gauge is to be measured " + in_mm(track.gauge_height) +
                       " below the top of the rail, but the head of rail '" + rail.name +
                       "' has no point at that height. Give a Track/Gauge height on the side of the head "
                       "(14 mm is usual).");

    placement.origin = {running_circle_distance(track) - 0.5 * track.gauge - gauge_side, -top};
    return placement;
  }


  Placement
  place_wheel(const TrackDimensions &track,
              const double           lateral_shift,
              const double           roll,
              const double           axle_height)
  {
    const double b = running_circle_distance(track), r = track.nominal_radius;
    const double c = std::cos(roll), s = std::sin(roll);
    Placement    placement;
    placement.angle = roll;
    // The running circle point lies at (-b, -r) from the middle of the axle.
    placement.origin = {b + lateral_shift - c * b + s * r, axle_height - s * b - c * r};
    return placement;
  }


  double
  gauge_face(const TrackDimensions &track)
  {
    return running_circle_distance(track) - 0.5 * track.gauge;
  }


  HeadPlace
  head_place(const Placement &rail, const TrackDimensions &track, const Point2 &point)
  {
    return {-rail.to_section(point).x, gauge_face(track) - point.x, -point.y};
  }
} // namespace wheelrail
