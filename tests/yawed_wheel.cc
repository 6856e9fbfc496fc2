// label: fast

// Rigid contact of a wheelset with yaw: the outline of the wheel along the track against the wheel itself.

#include "near.h"

#include <wheelrail/geometry/contact_geometry.h>
#include <wheelrail/geometry/touching_profiles.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

using namespace wheelrail;
using test::near;

namespace
{
  /// Smallest vertical gap between the placed wheel, point by point on its tread and around it, and the rail.
  struct Nearest
  {
    double gap = 1, X = 0, Z = 0;
  };

  Nearest
  nearest_point(const RailProfile     &rail,
                const WheelProfile    &wheel,
                const TrackDimensions &track,
                const ContactGeometry &contact)
  {
    const FrameProfile head(rail.head, contact.rail, ContactFrame(), 20);
    const Vector3      a       = contact.axis.direction;
    const Vector3      forward = normalised(Vector3{-a[2], 0, a[0]}), down = cross(a, forward);
    Nearest            best;
    const auto         look = [&](const double t0, const double t1, const double h0, const double h1) {
      constexpr int n = 200;
      Nearest       found;
      double        t_best = 0, h_best = 0;
      for (int i = 0; i <= n; ++i)
        for (int k = 0; k <= n; ++k)
          {
            const double t = t0 + (t1 - t0) * i / n, h = h0 + (h1 - h0) * k / n;
            const Point2 p   = wheel.tread.at(t).position;
            const double rho = track.nominal_radius - p.y, xi = -running_circle_distance(track) - p.x;
            Vector3      q = {contact.axis.middle.x, contact.axis.middle.y, 0};
            add(q, xi, a);
            add(q, rho * std::cos(h), down);
            add(q, rho * std::sin(h), forward);
            if (q[0] < head.s_min() || q[0] > head.s_max())
              continue;
            const double gap = q[1] - head.at(q[0]).n;
            if (gap < found.gap)
              {
                found  = {gap, q[0], q[2]};
                t_best = t;
                h_best = h;
              }
          }
      best = found;
      return Point2{t_best, h_best};
    };
    double width_t = wheel.tread.parameter_end() / 2, width_h = 0.1;
    Point2 centre = {width_t, 0};
    for (int round = 0; round < 12; ++round)
      {
        centre = look(std::max(0., centre.x - width_t),
                      std::min(wheel.tread.parameter_end(), centre.x + width_t),
                      centre.y - width_h,
                      centre.y + width_h);
        width_t /= 5;
        width_h /= 5;
      }
    return best;
  }

  std::string
  name_of(const WheelsetPose &pose)
  {
    return "shift " + std::to_string(1e3 * pose.lateral_shift) + " mm, yaw " +
           std::to_string(1e3 * pose.yaw) + " mrad, roll " + std::to_string(1e3 * pose.roll_angle) +
           " mrad: ";
  }

  BOOST_AUTO_TEST_CASE(test_direct_search)
  {
    const RailProfile     rail  = rail_profile("54E1");
    const WheelProfile    wheel = wheel_profile("S1002");
    const TrackDimensions track;
    for (const WheelsetPose &pose : {WheelsetPose{0, RollMode::given, 0, 5e-3},
                                     WheelsetPose{0, RollMode::given, 1e-3, -20e-3},
                                     WheelsetPose{-3.5e-3, RollMode::given, 0, 20e-3},
                                     WheelsetPose{3.5e-3, RollMode::given, -0.5e-3, -10e-3},
                                     WheelsetPose{-6e-3, RollMode::given, 0, 40e-3},
                                     WheelsetPose{-6e-3, RollMode::given, 1e-3, -40e-3}})
      {
        const ContactGeometry c     = find_contact(rail, wheel, track, pose);
        const Nearest         n     = nearest_point(rail, wheel, track, c);
        const std::string     which = name_of(pose);
        BOOST_TEST(near(n.gap, 0, 1e-10, which + "least gap of the whole wheel [m]"));
        BOOST_TEST(near(c.frame.origin.x, n.X, 1e-6, which + "lateral place [m]"));
        BOOST_TEST(near(c.along, n.Z, 1e-6, which + "place along the track [m]"));
        const double expected = -c.rolling_radius * std::tan(c.angle) * std::tan(pose.yaw);
        BOOST_TEST(
          near(c.ahead / expected, 1, 0.01, which + "place ahead of the axle over -r tan(angle) tan(yaw)"));
      }
  }

  /// A yaw turns both wheels, so that the same yaw of opposite sign changes wheels with the other side.
  BOOST_AUTO_TEST_CASE(test_both_wheels)
  {
    const RailProfile     rail  = rail_profile("54E1");
    const WheelProfile    wheel = wheel_profile("S1002");
    const TrackDimensions track;
    const WheelsetPose    pose{-2e-3, RollMode::from_contact, 0, 15e-3};
    const ContactGeometry here  = find_contact(rail, wheel, track, pose),
                          there = find_contact(rail, wheel, track, mirrored(pose));
    BOOST_TEST(near(here.roll, -there.roll, 1e-12, "roll from contact of both wheels [rad]"));
    BOOST_TEST(near(here.axis.middle.y, there.axis.middle.y, 1e-12, "height of the middle of the axle [m]"));
    BOOST_TEST(near(here.other_radius, there.rolling_radius, 1e-12, "radius of the other wheel [m]"));
    BOOST_TEST((here.along > 0 && there.along < 0), "the modelled wheel goes forward, the other one back");
    const ContactGeometry straight = find_contact(rail, wheel, track, {-2e-3, RollMode::from_contact});
    BOOST_TEST(std::abs(here.roll - straight.roll) > 1e-6, "yaw changes the roll at which both wheels touch");
  }

  /// The wheel as a body: its axle is that of the wheelset, and it touches at Z = 0 with its lowest line,
  /// where its surface has the normal of the rail.
  BOOST_AUTO_TEST_CASE(test_pose)
  {
    const RailProfile     rail  = rail_profile("54E1");
    const WheelProfile    wheel = wheel_profile("S1002");
    const TrackDimensions track;
    for (const WheelsetPose &pose : {WheelsetPose{0, RollMode::given, 0, 0},
                                     WheelsetPose{0, RollMode::given, 1e-3, -20e-3},
                                     WheelsetPose{3.5e-3, RollMode::given, -0.5e-3, 5e-3},
                                     WheelsetPose{-6e-3, RollMode::given, 1e-3, 40e-3}})
      {
        const ContactGeometry c     = find_contact(rail, wheel, track, pose);
        const std::string     which = name_of(pose);
        const Vector3         point = {c.frame.origin.x, c.frame.origin.y, 0}, axis = c.pose.axis();
        BOOST_TEST(near(norm(axis - c.axis.direction), 0, 1e-14, which + "direction of the axle"));
        const Vector3 middle = {c.axis.middle.x, c.axis.middle.y, -c.along};
        BOOST_TEST(near(norm(c.pose.centre() + running_circle_distance(track) * axis - middle),
                        0,
                        1e-14,
                        which + "middle of the wheelset from the wheel [m]"));
        BOOST_TEST(
          near(c.pose.angle(point), 0, 1e-8, which + "angle of the contact point about the axle [rad]"));
        const Point2 on_tread = c.pose.on_section(point);
        BOOST_TEST(
          near(norm(on_tread - c.tread_frame.origin), 0, 1e-9, which + "contact point on the tread [m]"));
        const Point2  n      = c.tread_frame.normal();
        const Vector3 normal = c.pose.motion.turned({n.x, n.y, 0});
        BOOST_TEST(near(norm(normal - Vector3{c.frame.normal().x, c.frame.normal().y, 0}),
                        0,
                        1e-6,
                        which + "normal of the wheel less that of the rail"));
        const Vector3 X = c.pose.position(0.01, 0.45, 0.3);
        BOOST_TEST(near(c.pose.angle(X), 0.3, 1e-14, which + "angle of a place [rad]"));
        BOOST_TEST(near(norm(c.pose.rolling(X) - cross(axis, X - c.pose.centre())),
                        0,
                        1e-14,
                        which + "rolling velocity over the pitch rate [m]"));
        BOOST_TEST(near(-c.pose.rolling(X)[2] / 0.45 / std::cos(0.3 + c.ahead / c.rolling_radius),
                        std::cos(pose.yaw),
                        2e-3,
                        which + "its part along the track"));
      }
  }

  /// The stretch along the track in which wheel and rail overlap, against the wheel point by point on its
  /// tread and around it.
  BOOST_AUTO_TEST_CASE(test_overlap)
  {
    const double approach = 0.1e-3;
    for (const auto &[shift, yaw] : {std::make_pair(0., 0.), {0., 20e-3}, {-6e-3, 40e-3}, {-6e-3, -40e-3}})
      {
        const WheelsetPose     pose{shift, RollMode::none, 0, yaw};
        const TouchingProfiles profiles =
          touching_profiles(rail_profile("54E1"), wheel_profile("S1002"), TrackDimensions(), pose);
        const ContactGeometry &c     = profiles.contact;
        const Range            range = overlap_along(profiles, approach, 0);
        const Curve           &tread = profiles.wheel.tread;
        double                 back = 0, front = 0;
        for (double t = 0; t <= tread.parameter_end(); t += 2e-3)
          for (double angle = -0.06; angle <= 0.06; angle += 2e-4)
            {
              const Point2  p = tread.at(t).position;
              const Vector3 X = c.pose.position(p.x, c.pose.nominal_radius - p.y, angle);
              const Point2  q = c.frame.to_frame({X[0], X[1]});
              if (q.x < profiles.rail_heights().s_min() || q.x > profiles.rail_heights().s_max() ||
                  q.y - approach > profiles.rail_heights().at(q.x).n)
                continue;
              back  = std::min(back, X[2]);
              front = std::max(front, X[2]);
            }
        const std::string which = name_of(pose);
        // the parabola has its full length in every slice, but leaves out that an inclined wheel is flatter
        BOOST_TEST((range.s0 < 0.97 * back && range.s1 > 0.97 * front), which + "the overlap is covered");
        BOOST_TEST(range.s1 - range.s0 < 1.5 * (front - back), which + "and not much more");
        const Range wider = overlap_along(profiles, approach, 3e-3);
        BOOST_TEST((wider.s0 <= range.s0 && wider.s1 >= range.s1 && (yaw == 0) == (wider.s1 == range.s1)),
                   which + "with yaw more beside the overlap");
      }
  }

  /// A cone of revolution: its outline is known in closed form.
  BOOST_AUTO_TEST_CASE(test_cone)
  {
    const double          slope = 0.3, yaw = 30e-3;
    const TrackDimensions track;
    const WheelProfile    cone{"cone",
                            Curve({line_segment("cone", {0.04, 0.04 * slope}, {-0.03, -0.03 * slope})})};
    const WheelOutline    outline = wheel_outline(cone, track, 0, yaw);
    // radius r0 - slope x, in front of the lowest place by asin(-slope tan(yaw))
    const double theta = std::asin(-slope * std::tan(yaw)), b = running_circle_distance(track);
    double       worst = 0;
    for (double t = 0; t <= outline.curve.parameter_end(); t += 0.37)
      {
        const Point2 p = outline.curve.at(t).position, q = cone.tread.at(outline.on_tread(t)).position;
        const double rho = track.nominal_radius - q.y;
        const double x   = -((-b - q.x) * std::cos(yaw) + rho * std::sin(theta) * std::sin(yaw)) - b,
                     y   = track.nominal_radius - rho * std::cos(theta);
        worst            = std::max(worst, norm(p - Point2{x, y}));
      }
    BOOST_TEST(near(worst, 0, 1e-14, "outline of a cone [m]"));
  }
} // namespace
