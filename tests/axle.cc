// label: fast

// Two wheels on one axle, in half-spaces: cones against kinematics (Klingel 1883), the rolling line of a
// curve, the balance of torques, and a mirror.

#include "cone_scene.h"
#include "near.h"

#include <wheelrail/vehicle/axle_contact.h>

#include <cmath>
#include <limits>
#include <optional>

using namespace wheelrail;
using test::cones;
using test::conicity;
using test::crown;
using test::near;
using test::wheel_of;

namespace
{
  AxleSolution
  solved(const Scene &scene, const AxleDrive &drive = {})
  {
    return solve_axle(
      wheel_of(scene, false, scene.wheel_load), wheel_of(scene, true, scene.wheel_load), drive);
  }

  double
  creepage(const std::optional<WheelRailSolution> &wheel)
  {
    return wheel->reference->creepage;
  }

  /// Half the distance of the contacts of a centred wheelset, and its rolling radius [m].
  struct Kinematics
  {
    double half_distance, radius;
  };
  Kinematics
  kinematics(const Scene &scene)
  {
    const WheelOnAxle wheel = wheel_of(scene, false, scene.wheel_load);
    return {std::abs(wheel.geometry.contact.frame.origin.x - wheel.geometry.contact.axis.middle.x),
            wheel.geometry.contact.rolling_radius};
  }

  /// A wheelset off its middle: the wheels have different radii and one rate, so that one drives and the
  /// other brakes.
  BOOST_AUTO_TEST_CASE(test_shifted_cones)
  {
    Scene            scene  = cones();
    const Kinematics known  = kinematics(scene);
    scene.lateral_shift     = -0.5e-3;
    const AxleSolution axle = solved(scene);
    const double       free = 2 * conicity * 0.5e-3 / known.radius;
    BOOST_TEST(near((creepage(axle.right) - creepage(axle.left)) / free,
                    1,
                    0.01,
                    "creepages of shifted cones differ by 2 lambda y / r0: ratio"));
    BOOST_TEST((axle.right->solution.fx < 0 && axle.left->solution.fx > 0), "the larger wheel drives");
    BOOST_TEST(near(axle.torque / (scene.wheel_load * known.radius), 0, 1e-4, "no torque on a free axle"));
    BOOST_TEST(
      near(axle.yaw_moment / ((axle.left->solution.fx - axle.right->solution.fx) * known.half_distance),
           1,
           0.05,
           "together they turn the nose away from the flange that is near: moment over force times b"));

    // with the roll that both contacts ask for, on the crown: lambda (b + R lambda)/(b - r0 lambda)
    scene.roll                = RollMode::from_contact;
    const double b            = known.half_distance,
                 with_roll    = conicity * (b + 1e-3 * crown * conicity) / (b - known.radius * conicity);
    const AxleSolution rolled = solved(scene);
    BOOST_TEST(
      near((creepage(rolled.right) - creepage(rolled.left)) * known.radius / (2 * 0.5e-3) / with_roll,
           1,
           0.01,
           "equivalent conicity with roll: ratio"));
  }

  /// On the rolling line nothing creeps along the track, though the rails have different lengths.
  BOOST_AUTO_TEST_CASE(test_rolling_line)
  {
    Scene            scene   = cones();
    const Kinematics known   = kinematics(scene);
    scene.track_radius       = 3000; // to the left: the right-hand wheel is the outer one
    scene.lateral_shift      = -known.radius * known.half_distance / (conicity * scene.track_radius);
    const AxleSolution axle  = solved(scene);
    const double       scale = known.half_distance / scene.track_radius;
    BOOST_TEST(near(
      creepage(axle.right) / scale, 0, 0.01, "creepage of the outer wheel on the rolling line, over b/R"));
    BOOST_TEST(near(creepage(axle.left) / scale, 0, 0.01, "and of the inner one"));
    // the spin of a curve adds to that of the cone on the outer wheel, and is taken off on the inner one
    const auto spin = [&](const std::optional<WheelRailSolution> &wheel, const double curve) {
      const double angle = wheel->reference->angle;
      return -std::sin(angle) / known.radius - curve * std::cos(angle) / scene.track_radius;
    };
    BOOST_TEST(
      near(axle.right->reference->spin / spin(axle.right, 1), 1, 0.01, "spin of the outer wheel: ratio"));
    BOOST_TEST(
      near(axle.left->reference->spin / spin(axle.left, -1), 1, 0.01, "spin of the inner wheel: ratio"));

    Scene straight           = scene;
    straight.track_radius    = std::numeric_limits<double>::infinity();
    const AxleSolution other = solved(straight);
    BOOST_TEST(near((creepage(other.right) - creepage(other.left)) / (2 * scale),
                    1,
                    0.01,
                    "straight on, the same place has creepages of +-b/R: ratio"));
  }

  /// The mirror image of a wheelset in a curve has the other wheel's forces.
  BOOST_AUTO_TEST_CASE(test_mirror)
  {
    Scene scene                  = cones();
    scene.lateral_shift          = -1e-3;
    scene.yaw                    = 1e-3;
    scene.track_radius           = 800;
    const AxleSolution one       = solved(scene);
    Scene              reflected = scene;
    reflected.lateral_shift      = 1e-3;
    reflected.yaw                = -1e-3;
    reflected.track_radius       = -800;
    const AxleSolution other     = solved(reflected);
    const double       load      = scene.wheel_load;
    BOOST_TEST(near(one.rate / other.rate, 1, 1e-9, "pitch rate of the mirror image: ratio"));
    BOOST_TEST(near((one.lateral + other.lateral) / load, 0, 1e-9, "lateral forces turn round"));
    BOOST_TEST(near((one.yaw_moment + other.yaw_moment) / load, 0, 1e-9, "so does the yaw moment"));
    BOOST_TEST(
      near((one.right->solution.fx - other.left->solution.fx) / load, 0, 1e-9, "right and left change"));
    BOOST_TEST(near((one.left->solution.fy - other.right->solution.fy) / load, 0, 1e-9, "of both wheels"));
  }

  /// Torque, loads that differ, a wheel off its rail, and more torque than friction carries.
  BOOST_AUTO_TEST_CASE(test_balance)
  {
    Scene scene            = cones();
    scene.lateral_shift    = -2e-3;
    scene.yaw              = 2e-3;
    const Kinematics known = kinematics(scene);
    AxleDrive        drive;
    drive.torque            = 0.2 * 160e3 * known.radius;
    const AxleSolution axle = solve_axle(wheel_of(scene, false, 100e3), wheel_of(scene, true, 60e3), drive);
    BOOST_TEST(
      near(axle.torque / drive.torque, 1, 1e-3, "the contacts ask for the torque of the drive: ratio"));
    BOOST_TEST(near(axle.right->vertical / 100e3, 1, 1.1e-3, "the right-hand wheel carries its load: ratio"));
    BOOST_TEST(near(axle.left->vertical / 60e3, 1, 1.1e-3, "the left-hand one, too: ratio"));
    BOOST_TEST((axle.right->solution.converged() && axle.left->solution.converged()),
               "the balance was found");

    const AxleSolution lifted = solve_axle(wheel_of(scene, false, 100e3), wheel_of(scene, true, 0), {});
    BOOST_TEST((lifted.right && !lifted.left), "a wheel without load does not touch");
    BOOST_TEST(near(lifted.torque / (100e3 * known.radius), 0, 1e-4, "the other one rolls freely"));

    drive.torque             = 1.2 * scene.friction.at_rest * 160e3 * known.radius;
    const AxleSolution spins = solve_axle(wheel_of(scene, false, 100e3), wheel_of(scene, true, 60e3), drive);
    BOOST_TEST((!spins.right->solution.within_friction && spins.torque < drive.torque),
               "friction does not carry more than it has");
    BOOST_TEST(near(spins.right->vertical / 100e3, 1, 1.1e-3, "the load is carried all the same: ratio"));

    drive.rate_held          = true;
    drive.creepage           = 2e-3;
    const AxleSolution given = solved(scene, drive);
    BOOST_TEST(near(given.right->solution.xi, 2e-3, 1e-12, "creepage of the right-hand wheel as given"));
  }
} // namespace
