#include <wheelrail/base/errors.h>
#include <wheelrail/contactfiles/wheel_rail_pose.h>
#include <wheelrail/tables/text_rows.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace wheelrail
{
  namespace
  {

    /// The place of the origin of the rail's section that the gauge asks for: the highest point at z = 0, the
    /// innermost point no deeper than GAUGHT half the gauge from the track centre.
    Vector3
    place_by_gauge(const ContactTrack &track, const ProfileLine &line, const RigidMotion &canted)
    {
      std::vector<Point2> points; // of the canted section
      for (const double t : line.samples())
        {
          const ProfileLine::Place p     = line.at(t);
          const Vector3            there = canted.turned({0, p.y, p.z});
          points.push_back({there[1], there[2]});
        }
      const auto top = std::min_element(
        points.begin(), points.end(), [](const Point2 &a, const Point2 &b) { return a.y < b.y; });
      const double depth = top->y + millimetre * track.gauge_height;
      double       inner = std::numeric_limits<double>::infinity();
      for (auto p = points.begin(); p != top; ++p)
        {
          if (p->y <= depth)
            inner = std::min(inner, p->x);
          if ((p->y - depth) * ((p + 1)->y - depth) < 0)
            inner = std::min(inner, p->x + ((p + 1)->x - p->x) * (depth - p->y) / ((p + 1)->y - p->y));
        }
      if (!std::isfinite(inner))
        throw InputError(place(track.profile.file, 1) +
                         "the rail has no place beside its top at which a gauge could be measured");
      return {0, 0.5 * millimetre * track.gauge - inner, -top->y};
    }
  } // namespace


  RigidMotion
  turned_by(const double roll, const double yaw)
  {
    const double r = std::cos(roll), s = std::sin(roll), c = std::cos(yaw), d = std::sin(yaw);
    RigidMotion  motion;
    motion.rows = {{{{c, -d, 0}}, {{r * d, r * c, -s}}, {{s * d, s * c, r}}}};
    return motion;
  }


  RigidMotion
  WheelRailPose::wheelset_to_track() const
  {
    RigidMotion motion = wheelset;
    motion.move[2] += height;
    return motion;
  }


  RigidMotion
  WheelRailPose::wheel_to_track() const
  {
    return then(wheel, wheelset_to_track());
  }


  BodyVelocity
  WheelRailPose::rail_at(const Vector3 &place) const
  {
    return {rail_motion.velocity + cross(rail_motion.rotation, place - rail.move) + roller_at(place),
            rail_motion.rotation + roller_turning};
  }


  Vector3
  WheelRailPose::roller_at(const Vector3 &place) const
  {
    return cross(roller_turning, place - axle);
  }


  BodyVelocity
  WheelRailPose::wheel_at(const Vector3 &place) const
  {
    const RigidMotion to_track = wheelset_to_track();
    const Vector3     own      = to_track.back(place); // in the axes of the wheelset
    const Vector3     bent     = wheel_motion.velocity + cross(wheel_motion.rotation, own - wheel.move);
    const Vector3     turning  = to_track.turned(wheelset_motion.rotation);
    return {wheelset_motion.velocity + cross(turning, place - to_track.move) + to_track.turned(bent),
            turning + to_track.turned(wheel_motion.rotation)};
  }


  Vector3
  WheelRailPose::rolling_at(const Vector3 &place) const
  {
    const RigidMotion to_track = wheelset_to_track();
    return cross(to_track.turned({0, wheelset_motion.rotation[1], 0}), place - to_track.move);
  }


  WheelRailPose
  wheel_rail_pose(const ContactCase &one, const ProfileLine &rail)
  {
    const ContactTrack           &track = one.track;
    const ContactWheelset        &set   = one.wheelset;
    const std::array<double, 6>  &p = set.position, &v = set.velocity, &d = track.deviation;
    const std::array<double, 12> &f = set.flexible;
    WheelRailPose                 pose;
    pose.left         = one.digits.side == 0 || one.digits.side == 4;
    const double side = pose.left ? -1 : 1;

    pose.rail      = turned_by(-track.cant + side * d[2], 0);
    pose.rail.move = track.gauge_height > 0 ? place_by_gauge(track, rail, turned_by(-track.cant, 0))
                                            : millimetre * Vector3{0, side * track.rail_y, track.rail_z};
    add(pose.rail.move, millimetre, {0, side * d[0], d[1]});
    pose.roller = one.digits.side >= 4;
    if (pose.roller)
      {
        // NOMRADR counts to the track plane, from an axle across the track that deviations do not move
        if (track.gauge_height > 0)
          pose.rail.move[2] = millimetre * d[1];
        pose.axle           = {0, 0, millimetre * track.roller_radius};
        pose.roller_turning = {0, v[0], 0};
      }
    pose.rail_motion = {millimetre * Vector3{0, side * d[3], d[4]}, {side * d[5], 0, 0}};

    pose.wheel_radius = millimetre * set.radius;
    pose.wheel        = turned_by(side * f[3], side * f[4]);
    pose.wheel.move =
      millimetre *
      Vector3{f[0], 0.5 * set.flange_distance - set.flange_place + side * f[1], set.radius + f[2]};
    pose.wheel_motion = {millimetre * Vector3{f[6], side * f[7], f[8]}, {side * f[9], f[11], side * f[10]}};
    pose.wheelset     = turned_by(side * p[3], side * p[4]);
    // along the track S_WS has moved the axes, too
    pose.wheelset.move   = millimetre * Vector3{pose.roller ? p[0] : 0, side * p[1], -set.radius};
    pose.height          = one.digits.normal == 1 ? 0 : millimetre * p[2];
    pose.wheelset_motion = {millimetre * Vector3{pose.roller ? 0 : v[0], side * v[1], v[2]},
                            {side * v[3], one.digits.forces == 1 ? 0 : v[5], side * v[4]}};
    return pose;
  }
} // namespace wheelrail
