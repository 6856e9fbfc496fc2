// Placement and 2D-Geo: contact points against the reference tables for all shifts and both roll
// modes, profiles in the contact frame, interpenetration, refused shifts.

#include "error_of.h"
#include "near.h"
#include "reference_table.h"

#include <wheelrail/application/geometry_command.h>
#include <wheelrail/base/errors.h>
#include <wheelrail/geometry/contact_geometry.h>
#include <wheelrail/vehicle/wheelset_contact.h>

#include <algorithm>
#include <cmath>
#include <sstream>

using namespace wheelrail;
using namespace test;

namespace
{
  const double degree = M_PI / 180;

  /// [m]: the terms of the polynomial of zone C reach 300 m and cancel to 5 mm.
  const double round_off = 1e-13;

  void
  test_placement()
  {
    const TrackDimensions track;
    const Placement a = place_rail(rail_profile("54E1"), track), b = place_rail(rail_profile("60E1"), track);
    BOOST_TEST(near((0.75 - a.origin.x) * 1e3, 752.066413, 1e-6, "54E1 crown from the track centre [mm]"));
    BOOST_TEST(near(a.origin.y * 1e3, -0.093706, 1e-6, "54E1 crown below the highest point [mm]"));
    BOOST_TEST(near((0.75 - b.origin.x) * 1e3, 753.034723, 1e-6, "60E1 crown from the track centre [mm]"));
    BOOST_TEST(near(b.origin.y * 1e3, -0.093706, 1e-6, "60E1 crown below the highest point [mm]"));
    const Point2 p = {0.003, -0.02};
    BOOST_TEST(near(norm(a.to_section(a.to_track(p)) - p), 0, 1e-16, "to_section undoes to_track [m]"));
    BOOST_TEST((a.to_track({0, 0.1}).x > a.to_track({0, 0}).x), "the rail leans towards the track centre");
    BOOST_TEST((a.to_track({0.01, 0}).x < a.to_track({0, 0}).x), "the field side lies at smaller X");
  }

  /// The tables hold a wheelset with the shift positive to the right. The modelled wheel is the
  /// table's left wheel seen along its own X, which there points to the right; the table's right
  /// wheel is its mirror image, with shift and roll of opposite sign.
  void
  test_reference_points()
  {
    const RailProfile     rail  = rail_profile("54E1");
    const WheelProfile    wheel = wheel_profile("S1002");
    const TrackDimensions track;
    const auto            table = read_table("contact_points_54E1.csv");
    BOOST_TEST(table.size() == 36, "36 contact points in the table");

    double point = 0, angle = 0, radius = 0, roll = 0, lift = 0, rail_radius = 0, wheel_radius = 0,
           second = 0, place = 0;
    for (const auto &row : table)
      {
        const auto            number = [&](const int column) { return std::stod(row[column]); };
        const double          sign   = row[2] == "left" ? 1 : -1;
        const RollMode        mode   = row[0] == "no_roll" ? RollMode::none : RollMode::from_contact;
        const ContactGeometry c      = find_contact(rail, wheel, track, {sign * 1e-3 * number(1), mode});
        point                        = std::max({point,
                                                 std::abs(1e3 * c.wheel_x - number(5)),
                                                 std::abs(1e3 * c.wheel_y - number(6)),
                                                 std::abs(1e3 * c.rail_x - number(9)),
                                                 std::abs(1e3 * c.rail_y - number(10))});
        angle                        = std::max(angle, std::abs(c.angle / degree - number(15)));
        radius                       = std::max(radius, std::abs(1e3 * c.rolling_radius - number(8)));
        roll                         = std::max(roll, std::abs(sign * c.roll - number(3)));
        // The table gives the height of the axle's middle.
        const double middle = c.axle.y + std::sin(c.roll) * running_circle_distance(track);
        lift                = std::max(lift, std::abs(1e3 * (middle - track.nominal_radius) - number(4)));
        place               = std::max({place,
                                        std::abs(1e3 * (c.frame.origin.x - 0.75) - sign * number(12)),
                                        std::abs(1e3 * c.frame.origin.y - number(13))});
        rail_radius         = std::max(rail_radius, std::abs(1e3 / c.rail_curvature / number(16) - 1));
        wheel_radius        = std::max(wheel_radius, std::abs(1e3 / c.wheel_curvature / number(17) - 1));
        BOOST_TEST((c.wheel_segment == row[7] && c.rail_segment == row[11]),
                   "zone " + row[7] + " on '" + row[11] + "' at shift " + row[1] + " mm, " + row[0] + ", " +
                     row[2]);
        if (row.size() > 19 && row[19].size() > 1)
          {
            const auto at = row[19].find('@');
            second        = std::max({second,
                                      std::abs(1e3 * c.second_gap - std::stod(row[19].substr(0, at))),
                                      std::abs(c.second_rail_x - 1e-3 * std::stod(row[19].substr(at + 1)))});
          }
      }
    BOOST_TEST(near(point, 0, 1e-4, "contact points, largest difference [mm] (asked: 0.02)"));
    BOOST_TEST(near(angle, 0, 1e-4, "contact angle, largest difference [degrees] (asked: 0.05)"));
    BOOST_TEST(near(radius, 0, 1e-5, "rolling radius, largest difference [mm] (asked: 0.001)"));
    BOOST_TEST(near(roll, 0, 1e-8, "roll, largest difference [rad]"));
    BOOST_TEST(near(lift, 0, 1e-5, "height of the axle, largest difference [mm]"));
    BOOST_TEST(near(place, 0, 1e-4, "place in the track plane, largest difference [mm]"));
    BOOST_TEST(near(rail_radius, 0, 1e-4, "lateral radius of the rail, largest relative difference"));
    BOOST_TEST(near(wheel_radius, 0, 1e-3, "lateral radius of the wheel, largest relative difference"));
    BOOST_TEST(near(second, 0, 1e-5, "second minimum: gap [mm], place [m]"));
  }

  void
  test_radius_differences()
  {
    const RailProfile     rail  = rail_profile("54E1");
    const WheelProfile    wheel = wheel_profile("S1002");
    const TrackDimensions track;
    double                none = 0, both = 0;
    for (const auto &row : read_table("rolling_radius_difference_54E1.csv"))
      {
        const double shift      = 1e-3 * std::stod(row[0]);
        const auto   difference = [&](const RollMode mode) {
          // The table's right wheel is ours with the shift reversed.
          return 1e3 * (find_contact(rail, wheel, track, {-shift, mode}).rolling_radius -
                        find_contact(rail, wheel, track, {shift, mode}).rolling_radius);
        };
        none = std::max(none, std::abs(difference(RollMode::none) - std::stod(row[1])));
        both = std::max(both, std::abs(difference(RollMode::from_contact) - std::stod(row[2])));
      }
    BOOST_TEST(
      near(none, 0, 1e-4, "rolling radius difference 0 to 7 mm without roll, largest difference [mm]"));
    BOOST_TEST(near(both, 0, 1e-4, "rolling radius difference 0 to 7 mm with roll, largest difference [mm]"));
  }

  void
  test_frame_profiles()
  {
    const RailProfile  rail  = rail_profile("54E1");
    const WheelProfile wheel = wheel_profile("S1002");
    for (const double shift : {0., -5.5e-3, 3.5e-3})
      {
        const std::string     where = " at shift " + std::to_string(shift * 1e3) + " mm";
        const ContactGeometry c     = find_contact(rail, wheel, TrackDimensions(), {shift, RollMode::none});
        const FrameProfile    w(wheel.tread, c.wheel, c.frame), r(rail.head, c.rail, c.frame);
        BOOST_TEST(
          near(undeformed_distance(w, r, 0), 0, round_off, "distance at the contact point [m]" + where));
        BOOST_TEST(
          near(w.at(0).slope - r.at(0).slope, 0, 1e-8, "difference of slopes at the contact point" + where));

        double       off = 0, slope = 0, lowest = 0;
        const double low = std::max(w.s_min(), r.s_min()), high = std::min(w.s_max(), r.s_max());
        for (int i = 0; i <= 1000; ++i)
          {
            const double s = low + (high - low) * i / 1000, h = 1e-7;
            lowest = std::min(lowest, undeformed_distance(w, r, s));
            for (const bool is_wheel : {true, false})
              {
                const FrameProfile &p         = is_wheel ? w : r;
                const Curve        &curve     = is_wheel ? wheel.tread : rail.head;
                const Placement    &placement = is_wheel ? c.wheel : c.rail;
                const Point2 at = c.frame.to_frame(placement.to_track(curve.at(p.parameter(s)).position));
                // Published coefficients jump by 0.12 micrometres between zones D and C.
                const bool joint = std::any_of(p.joints().begin(), p.joints().end(), [&](const double t) {
                  return std::abs(t - s) < 1e-6;
                });
                if (!joint)
                  {
                    off = std::max(off, norm(at - Point2{s, p.at(s).n}));
                    if (s - h > low && s + h < high)
                      slope =
                        std::max(slope, std::abs((p.at(s + h).n - p.at(s - h).n) / (2 * h) - p.at(s).slope));
                  }
              }
          }
        BOOST_TEST(near(off, 0, round_off, "n(s) against the curve itself [m]" + where));
        BOOST_TEST(near(slope, 0, 1e-6, "dn/ds against difference quotient" + where));
        BOOST_TEST(lowest >= -round_off, "nothing interpenetrates in touch" + where);

        const auto ranges = interpenetration(w, r, 1e-4);
        BOOST_TEST(!ranges.empty(), "there is interpenetration at 0.1 mm" + where);
        double edges         = 0;
        bool   holds_contact = false;
        for (const Range &range : ranges)
          {
            edges         = std::max({edges,
                                      std::abs(undeformed_distance(w, r, range.s0) - 1e-4),
                                      std::abs(undeformed_distance(w, r, range.s1) - 1e-4)});
            holds_contact = holds_contact || (range.s0 < 0 && range.s1 > 0);
          }
        BOOST_TEST(
          near(edges, 0, round_off, "distance at the ends of interpenetration less 0.1 mm [m]" + where));
        BOOST_TEST(holds_contact, "the contact point lies in the interpenetration" + where);
      }

    const ContactGeometry c = find_contact(rail, wheel, TrackDimensions(), {0, RollMode::none});
    const FrameProfile    w(wheel.tread, c.wheel, c.frame), r(rail.head, c.rail, c.frame);
    const double          kappa = c.rail_curvature + c.wheel_curvature;
    BOOST_TEST(near(undeformed_distance(w, r, 1e-4) / (0.5e-8 * kappa),
                    1,
                    0.05,
                    "distance near the point is kappa s^2 / 2, ratio"));
  }

  void
  refused(const double shift, const RollMode mode)
  {
    const std::string  text = test::error_of<InputError>([&]() {
      find_contact(rail_profile("54E1"), wheel_profile("S1002"), TrackDimensions(), {shift, mode});
    });
    std::ostringstream number;
    number << 1e3 * shift << " mm";
    BOOST_TEST(
      (text.find(number.str()) != std::string::npos && text.find("are possible") != std::string::npos),
      "a shift of " + number.str() + " is refused: " + text);
  }

  void
  test_other_pair()
  {
    // 60E1 has no table of points; the touching itself is checked.
    const RailProfile  rail  = rail_profile("60E1");
    const WheelProfile wheel = wheel_profile("S1002");
    double             worst = 0, lowest = 0;
    for (int i = -12; i <= 12; ++i)
      for (const RollMode mode : {RollMode::none, RollMode::from_contact})
        {
          const ContactGeometry c = find_contact(rail, wheel, TrackDimensions(), {0.5e-3 * i, mode});
          const FrameProfile    w(wheel.tread, c.wheel, c.frame), r(rail.head, c.rail, c.frame);
          worst = std::max(
            worst, norm(c.wheel.to_track({c.wheel_x, c.wheel_y}) - c.rail.to_track({c.rail_x, c.rail_y})));
          const double low = std::max(w.s_min(), r.s_min()), high = std::min(w.s_max(), r.s_max());
          for (int k = 0; k <= 400; ++k)
            lowest = std::min(lowest, undeformed_distance(w, r, low + (high - low) * k / 400));
        }
    BOOST_TEST(near(worst, 0, round_off, "60E1: wheel and rail points coincide over -6 to 6 mm [m]"));
    BOOST_TEST(near(lowest, 0, round_off, "60E1: nothing interpenetrates over -6 to 6 mm [m]"));
  }

  void
  test_command()
  {
    Scene              scene;
    std::ostringstream plain, wide;
    BOOST_TEST((run_geometry_command(scene, read_profiles(scene), {}, plain) == 0), "the command returns 0");
    const std::string text = plain.str();
    BOOST_TEST((text.find("-29.731   -26.076   19.628   463.8240") != std::string::npos),
               "the command lists shift -5.5 mm");
    BOOST_TEST((text.find("at 0.672 mm: wheel x from") != std::string::npos),
               "the command finds the jump near 0.67 mm");
    BOOST_TEST((text.find("undeformed distance at s = -10 mm") != std::string::npos),
               "the command gives the details");
    std::ostringstream two;
    run_geometry_command(scene, read_profiles(scene), {-4.6e-3}, two);
    BOOST_TEST((two.str().find("Further points that 0.1 mm of approach would close\n\n    shift      gap") !=
                  std::string::npos &&
                two.str().find("\n    -4.60   0.0086   -18.560   -16.047    7.679") != std::string::npos),
               "further points have lines of their own");
    // cones on both sides: conicity is half the sum of their slopes, around where both roll alike
    Scene cones                  = scene;
    cones.both_wheels            = true;
    cones.wheel_profile          = "cone 1:20";
    cones.left_wheel_profile     = "cone 1:40";
    const WheelsetProfiles sides = read_wheelset_profiles(cones);
    std::ostringstream     unlike;
    run_geometry_command(cones, sides.right, {0}, unlike, &sides.left);
    BOOST_TEST((unlike.str().find("460.2709     0.3225") != std::string::npos),
               "difference of the radii of two cones: 0.32254 mm");
    BOOST_TEST((unlike.str().find("amplitude 1 mm   0.0375") != std::string::npos), "conicity of two cones");
    // the line lies 4.3 mm to one side, where the flange comes to the rail 2 mm farther; not on a wider track
    cones.track.gauge = 1.445;
    std::ostringstream wider;
    run_geometry_command(cones, sides.right, {0}, wider, &sides.left);
    for (const char *const amplitude : {"1", "2", "3", "4"})
      BOOST_TEST(
        (wider.str().find(std::string("amplitude ") + amplitude + " mm   0.0375") != std::string::npos),
        std::string("conicity of two cones on a wide track, amplitude [mm]: ") + amplitude);
    std::ostringstream rolled;
    scene.roll       = RollMode::given;
    scene.roll_angle = 2e-3;
    run_geometry_command(scene, read_profiles(scene), {0}, rolled);
    BOOST_TEST((rolled.str().find("Roll 2 mrad") != std::string::npos &&
                rolled.str().find("Roll none") == std::string::npos &&
                rolled.str().find("    0.00   2.0000") != std::string::npos),
               "the table has the roll that is given");
    scene.roll          = RollMode::none;
    scene.lateral_shift = 0.06;
    BOOST_TEST((run_geometry_command(scene, read_profiles(scene), {0.06, 0}, wide) == 1),
               "a scene without contact returns 1");
    BOOST_TEST((wide.str().find("no contact") != std::string::npos &&
                wide.str().find("460.4288") != std::string::npos),
               "a shift without contact gets its line, the others are listed");
  }

  /// Other tracks: wheel and rail touch in one point and nowhere overlap.
  void
  test_other_tracks()
  {
    const RailProfile  rail   = rail_profile("54E1");
    const WheelProfile wheel  = wheel_profile("S1002");
    double             lowest = 0, steps = 0;
    for (const double inclination : {0., 1. / 20, 1. / 30})
      for (const double gauge : {1.430, 1.445})
        {
          TrackDimensions track;
          track.inclination = inclination;
          track.gauge       = gauge;
          double before     = 0;
          for (int i = -8; i <= 8; ++i)
            {
              const ContactGeometry c =
                find_contact(rail, wheel, track, {0.5e-3 * i, RollMode::from_contact});
              const FrameProfile w(wheel.tread, c.wheel, c.frame), r(rail.head, c.rail, c.frame);
              const double       low = std::max(w.s_min(), r.s_min()), high = std::min(w.s_max(), r.s_max());
              for (int k = 0; k <= 400; ++k)
                lowest = std::min(lowest, undeformed_distance(w, r, low + (high - low) * k / 400));
              // To the field side the contact moves to smaller radii, by steps of either size.
              if (i > -8)
                steps = std::max(steps, c.rolling_radius - before);
              before = c.rolling_radius;
            }
        }
    BOOST_TEST(near(lowest, 0, round_off, "other tracks: nothing interpenetrates [m]"));
    BOOST_TEST(near(steps, 0, 1e-9, "other tracks: the rolling radius falls with the shift [m]"));
  }
} // namespace


BOOST_AUTO_TEST_CASE(geometry_contact)
{
  test_placement();
  test_reference_points();
  test_radius_differences();
  test_frame_profiles();
  test_other_pair();
  test_other_tracks();
  test_command();
  refused(60e-3, RollMode::none);
  refused(60e-3, RollMode::from_contact);
  refused(-60e-3, RollMode::none);
  refused(0.2, RollMode::none);
  refused(-18e-3, RollMode::from_contact);
}
