// Rigid contact of a wheelset with yaw: the outline of the wheel along the track against the wheel itself.

#include "check.h"

#include <wheelrail/geometry/contact_geometry.h>

#include <algorithm>
#include <cmath>
#include <string>

using namespace wheelrail;
using test::check;
using test::check_near;

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

  void
  test_direct_search()
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
        check_near(n.gap, 0, 1e-10, which + "least gap of the whole wheel [m]");
        check_near(c.frame.origin.x, n.X, 1e-6, which + "lateral place [m]");
        check_near(c.along, n.Z, 1e-6, which + "place along the track [m]");
        const double expected = -c.rolling_radius * std::tan(c.angle) * std::tan(pose.yaw);
        check_near(
          c.ahead / expected, 1, 0.01, which + "place ahead of the axle over -r tan(angle) tan(yaw)");
      }
  }

  /// A yaw turns both wheels, so that the same yaw of opposite sign changes wheels with the other side.
  void
  test_both_wheels()
  {
    const RailProfile     rail  = rail_profile("54E1");
    const WheelProfile    wheel = wheel_profile("S1002");
    const TrackDimensions track;
    const WheelsetPose    pose{-2e-3, RollMode::from_contact, 0, 15e-3};
    const ContactGeometry here  = find_contact(rail, wheel, track, pose),
                          there = find_contact(rail, wheel, track, mirrored(pose));
    check_near(here.roll, -there.roll, 1e-12, "roll from contact of both wheels [rad]");
    check_near(here.axis.middle.y, there.axis.middle.y, 1e-12, "height of the middle of the axle [m]");
    check_near(here.other_radius, there.rolling_radius, 1e-12, "radius of the other wheel [m]");
    check(here.along > 0 && there.along < 0, "the modelled wheel goes forward, the other one back");
    const ContactGeometry straight = find_contact(rail, wheel, track, {-2e-3, RollMode::from_contact});
    check(std::abs(here.roll - straight.roll) > 1e-6, "yaw changes the roll at which both wheels touch");
  }

  /// A cone of revolution: its outline is known in closed form.
  void
  test_cone()
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
    check_near(worst, 0, 1e-14, "outline of a cone [m]");
  }
} // namespace

int
main()
{
  test_direct_search();
  test_both_wheels();
  test_cone();
  return test::report();
}
