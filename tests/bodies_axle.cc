// Two wheels on one axle as true bodies: the torques of both balance, a wheel of the axle is that wheel alone
// at the same rate, a mirror, and the pose in which a wheelset runs through a curve.

#include "messages.h"

#include <wheelrail/vehicle/wheelset_contact.h>

#include <cmath>
#include <optional>
#include <string>
#include <vector>

using namespace wheelrail;
using test::near;
using test::near_relative;

namespace
{
  Scene
  both(std::vector<std::string> sets)
  {
    sets.insert(sets.end(),
                {"Half-space/Bodies = real", "Half-space/Element size = 0.8 mm", "Wheelset/Wheels = both"});
    return scene_from_text("", "x.prm", sets).scene;
  }

  WheelsetSolution
  solved(const Scene &scene)
  {
    const WheelsetProfiles profiles = read_wheelset_profiles(scene);
    return solve_wheelset(
      wheel_of_wheelset(scene, false), wheel_of_wheelset(scene, true), profiles, std::nullopt, 2);
  }

  BOOST_AUTO_TEST_CASE(test_axle)
  {
    const std::string load = "Wheelset/Wheel load = 100 kN", driven = "Wheelset/Traction coefficient = 0.25";
    const WheelsetSolution wheelset =
      solved(both({"Wheelset/Lateral shift = -1 mm", "Wheelset/Yaw = 1 mrad", load, driven}));
    const AxleSolution &axle = wheelset.axle;
    BOOST_TEST((axle.right->solution.converged() && axle.left->solution.converged()),
               "both wheels are solved");
    BOOST_TEST(near(axle.torque / (200e3 * 0.46), 0.25, 3e-4, "torque of the drive over load and radius"));
    BOOST_TEST(-axle.right->solution.fx > 1.2 * -axle.left->solution.fx, "the larger wheel drives more");
    for (const bool left : {false, true})
      {
        const WheelRailSolution &own   = left ? *axle.left : *axle.right;
        const WheelOnAxle       &wheel = left ? wheelset.left : wheelset.right;
        WheelOnAxle              lone  = wheel;
        lone.scene                     = single_wheel(wheelset, left);
        const auto alone               = solve_alone(lone, std::nullopt);
        const auto of_side             = [&](const std::string &what) {
          return (left ? "left wheel alone: " : "right wheel alone: ") + what;
        };
        BOOST_TEST(near_relative(own.vertical, 100e3, 2e-4, of_side("load")));
        BOOST_TEST(near_relative(alone->solution.fx, own.solution.fx, 2e-3, of_side("longitudinal force")));
        BOOST_TEST(near_relative(alone->lateral, own.lateral, 5e-3, of_side("lateral force")));
        BOOST_TEST(near_relative(
          alone->measures.peak_pressure, own.measures.peak_pressure, 1e-3, of_side("peak pressure")));
      }

    const WheelsetSolution mirror =
      solved(both({"Wheelset/Lateral shift = 1 mm", "Wheelset/Yaw = -1 mrad", load, driven}));
    BOOST_TEST(near_relative(
      mirror.axle.left->solution.fx, axle.right->solution.fx, 1e-3, "mirror: longitudinal force"));
    BOOST_TEST(near_relative(mirror.axle.right->lateral, axle.left->lateral, 1e-3, "mirror: lateral force"));
  }

  /// The pose is found with half-spaces and mended with the bodies.
  BOOST_AUTO_TEST_CASE(test_curve)
  {
    const WheelsetSolution wheelset = solved(both({"Wheelset/Pose = equilibrium",
                                                   "Wheelset/Wheel load = 100 kN",
                                                   "Wheelset/Traction coefficient = 0",
                                                   "Wheelset/Velocity = 60 km/h",
                                                   "Track/Radius = 1000 m"}));
    const double           load     = wheelset.right.load + wheelset.left.load,
                 base               = half_base(wheelset.right.geometry, wheelset.left.geometry);
    BOOST_TEST(wheelset.axle.right->solution.converged(), "curve: the pose is found");
    BOOST_TEST(near(wheelset.lateral_missed / load, 0, 1e-4, "curve: lateral forces balance"));
    BOOST_TEST(near(wheelset.yaw_missed / (load * base), 0, 1e-4, "curve: yaw moments balance"));
    BOOST_TEST(near(1e3 * wheelset.right.scene.lateral_shift, -1.86, 0.1, "curve: lateral shift, mm"));
    BOOST_TEST((wheelset.right.scene.halfspace_bodies == ContactBodies::real), "curve: with the true bodies");
    for (const auto *wheel : {&wheelset.axle.right, &wheelset.axle.left})
      BOOST_TEST(std::abs((*wheel)->reference->creepage) < 0.3e-3, "curve: it rolls nearly without creepage");
  }
} // namespace
