// A wheelset that finds its pose: the rolling line of cones, springs, a mirror; what a curve with cant does
// to its loads; the search itself; one wheel taken from it; full slip on the flange (Nadal 1896).

#include "cone_scene.h"
#include "near.h"

#include <wheelrail/bodies/body_contact.h>
#include <wheelrail/vehicle/pair_root.h>
#include <wheelrail/vehicle/wheelset_contact.h>
#include <wheelrail/vehicle/wheelset_figures.h>
#include <wheelrail/wheel/halfspace_case.h>

#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <vector>

using namespace wheelrail;
using test::conicity;
using test::near;
using test::same_text;

namespace
{
  Scene
  free_cones(const double radius)
  {
    Scene scene         = test::cones();
    scene.both_wheels   = true;
    scene.pose_balances = true;
    scene.track_radius  = radius;
    return scene;
  }

  WheelsetSolution
  solved(const Scene &scene)
  {
    return solve_wheelset(wheel_of_wheelset(scene, false),
                          wheel_of_wheelset(scene, true),
                          read_wheelset_profiles(scene),
                          std::nullopt,
                          2);
  }

  double
  axle_load(const WheelsetSolution &wheelset)
  {
    return wheelset.right.load + wheelset.left.load;
  }

  void
  check_balanced(const WheelsetSolution &wheelset, const std::string &what)
  {
    const double base = half_base(wheelset.right.geometry, wheelset.left.geometry);
    BOOST_TEST(
      near(wheelset.lateral_missed / axle_load(wheelset), 0, 1e-4, what + ": lateral forces balance"));
    BOOST_TEST(
      near(wheelset.yaw_missed / (axle_load(wheelset) * base), 0, 1e-4, what + ": yaw moments balance"));
    BOOST_TEST((wheelset.axle.right->solution.converged() && wheelset.axle.left->solution.converged()),
               what + ": is found");
  }

  /// A free wheelset of cones runs outwards until its radii fit the curve: y = r0 b / (lambda R).
  BOOST_AUTO_TEST_CASE(test_rolling_line)
  {
    const WheelsetSolution left = solved(free_cones(3000));
    const double           base = half_base(left.right.geometry, left.left.geometry),
                 radius         = free_cones(3000).track.nominal_radius;
    check_balanced(left, "a free wheelset");
    // the spin of the cones pushes outwards a little, and is held by a small yaw
    BOOST_TEST(near(left.right.scene.lateral_shift * conicity * 3000 / (radius * base),
                    -1,
                    0.01,
                    "rolling line of cones: ratio"));
    BOOST_TEST(near(
      left.axle.right->reference->creepage * 3000 / base, 0, 0.01, "no creepage along the track, over b/R"));
    // free wheels roll along a sine whose curvature is that of the rolling line at each place: y'' = -y / (R
    // y_R)
    BOOST_TEST(near(std::sqrt(-left.right.scene.lateral_shift * 3000 / (base * radius / conicity)),
                    1,
                    0.01,
                    "wave length of Klingel's motion over 2 pi sqrt(b r0 / lambda)"));
    BOOST_TEST(near(left.right.scene.yaw, 0, 1e-4, "it stands nearly along the radius [rad]"));

    const WheelsetSolution right = solved(free_cones(-3000));
    BOOST_TEST(near((right.right.scene.lateral_shift + left.right.scene.lateral_shift) /
                      left.right.scene.lateral_shift,
                    0,
                    1e-9,
                    "in a curve to the right the same to the other side"));
    BOOST_TEST(near(right.axle.left->lateral / left.axle.right->lateral, 1, 1e-9, "with the same forces"));
  }

  /// A stiff spring keeps the pose, and takes what the contacts leave over.
  BOOST_AUTO_TEST_CASE(test_springs)
  {
    Scene scene                     = free_cones(3000);
    scene.lateral_shift             = -1e-3;
    scene.lateral_stiffness         = 1e9;
    scene.yaw_stiffness             = 1e9;
    const WheelsetSolution wheelset = solved(scene);
    check_balanced(wheelset, "a wheelset on springs");
    BOOST_TEST(near(
      wheelset.right.scene.lateral_shift / scene.lateral_shift, 1, 0.01, "a stiff spring keeps the shift"));
    BOOST_TEST(near(wheelset.axle.yaw_moment / (1e9 * wheelset.right.scene.yaw),
                    1,
                    0.01,
                    "the spring holds the steering moment"));
    BOOST_TEST(wheelset.axle.yaw_moment < 0,
               "which turns the nose into the curve's outside where the shift is too small");
  }

  BOOST_AUTO_TEST_CASE(test_curve_loads)
  {
    Scene        scene = test::cones();
    const double base = 0.75, h = scene.centre_height, g = scene.gravity;
    BOOST_TEST(near(curve_loads(scene, 80e3, 70e3, base).left, 70e3, 0, "without cant loads are as given"));
    BOOST_TEST(std::isnan(curve_loads(scene, 80e3, 70e3, base).acceleration),
               "and what it leaves over is unknown");
    scene.track_radius = 500;
    scene.velocity     = 20;
    scene.cant         = 2 * base / g * scene.velocity * scene.velocity / scene.track_radius;
    CurveLoads loads   = curve_loads(scene, 80e3, 80e3, base);
    BOOST_TEST(near(loads.right / 80e3, 1, 1e-12, "a cant that balances V^2/R = g c/(2 b): equal loads"));
    BOOST_TEST(near(loads.lateral, 0, 1e-6, "and no lateral force"));
    scene.cant        = 0;
    loads             = curve_loads(scene, 80e3, 80e3, base);
    const double over = scene.velocity * scene.velocity / scene.track_radius;
    BOOST_TEST(
      near(loads.right / 80e3 - 1, h / base * over / g, 1e-12, "load transfer (h/b) a/g to the outer wheel"));
    BOOST_TEST(near(loads.right + loads.left, 160e3, 1e-6, "the axle load stays"));
    BOOST_TEST(near(loads.lateral, 160e3 / g * over, 1e-6, "what the rails owe"));
    scene.velocity = 60;
    loads          = curve_loads(scene, 80e3, 80e3, base);
    BOOST_TEST((loads.left == 0 && loads.right == 160e3), "the inner wheel is lifted");
  }

  BOOST_AUTO_TEST_CASE(test_pair_root)
  {
    // a circle and a line, which have no values left of the middle
    const PairFunction function = [](const Pair &at) -> std::optional<Pair> {
      if (at[0] < 0)
        return {};
      return Pair{at[0] * at[0] + at[1] * at[1] - 25, at[0] - at[1] + 1};
    };
    const PairSearch search{{1e-4, 1e-4}, {2, 2}, 1e-10, 40};
    const auto       root = find_pair_root({{1, 1}, {}, {}}, search, function, function);
    BOOST_TEST((root && root->found), "the root is found");
    BOOST_TEST(near(root->at[0], 3, 1e-8, "first unknown"));
    BOOST_TEST(near(root->at[1], 4, 1e-8, "second unknown"));
    BOOST_TEST(!find_pair_root({{-1, 1}, {}, {}}, search, function, function),
               "nothing where there are no values");
    const auto none = find_pair_root(
      {{1, 1}, {}, {}},
      search,
      [](const Pair &at) {
        return Pair{at[0] * at[0] + 1, at[1]};
      },
      [](const Pair &at) {
        return Pair{at[0] * at[0] + 1, at[1]};
      });
    BOOST_TEST((none && !none->found), "no root is no root");
  }

  /// Alone it carries the load and turns at the rate that it had on the axle.
  BOOST_AUTO_TEST_CASE(test_single_wheel)
  {
    Scene scene                     = free_cones(std::numeric_limits<double>::infinity());
    scene.pose_balances             = false;
    scene.lateral_shift             = -0.5e-3;
    scene.left_friction             = 0.2;
    const WheelsetSolution wheelset = solved(scene);
    for (const bool left : {false, true})
      {
        const Scene             one      = single_wheel(wheelset, left);
        const SceneGeometry     geometry = make_geometry(one);
        const WheelRailSolution alone =
          solve_wheel_rail(one, geometry, scene_load(one, geometry), scene_offsets(one));
        const WheelRailSolution &there = left ? *wheelset.axle.left : *wheelset.axle.right;
        const std::string        side  = left ? "left" : "right";
        BOOST_TEST((one.left_wheel == left && !one.both_wheels), side + ": one wheel");
        BOOST_TEST(near(
          one.friction.at_rest, left ? 0.2 : scene.friction.at_rest, 0, side + ": friction of its rail"));
        BOOST_TEST(near(alone.reference->creepage / there.reference->creepage,
                        1,
                        1e-3,
                        side + ": creepage alone over that on the axle"));
        BOOST_TEST(near(alone.vertical / there.vertical, 1, 1e-3, side + ": vertical force"));
        BOOST_TEST(near((alone.solution.fx - there.solution.fx) / there.solution.fx,
                        0,
                        2e-3,
                        side + ": longitudinal force"));
      }
  }

  /// A rail of its own under the left-hand wheel.
  BOOST_AUTO_TEST_CASE(test_different_rails)
  {
    Scene scene                     = Scene();
    scene.both_wheels               = true;
    scene.rigid_axle                = false;
    scene.lateral_shift             = -1e-3;
    scene.left_rail_profile         = "60E1";
    scene.wheel_load                = 80e3;
    const WheelsetSolution wheelset = solved(scene);
    for (const bool left : {false, true})
      {
        Scene alone        = scene;
        alone.both_wheels  = false;
        alone.left_wheel   = left;
        alone.rail_profile = left ? "60E1" : scene.rail_profile;
        const auto one     = solve_alone({alone, make_geometry(alone), scene.wheel_load}, std::nullopt);
        const auto there   = left ? wheelset.axle.left : wheelset.axle.right;
        BOOST_TEST(near(there->solution.peak_pressure / one->solution.peak_pressure,
                        1,
                        1e-9,
                        std::string(left ? "left" : "right") + " wheel on its own rail: peak pressure"));
        BOOST_TEST(near(there->lateral / one->lateral, 1, 1e-9, "and lateral force"));
      }
    BOOST_TEST(near(wheelset.axle.left->solution.peak_pressure / wheelset.axle.right->solution.peak_pressure,
                    1,
                    0.5,
                    "the rails differ, but not much"));
    BOOST_TEST((wheelset.axle.left->solution.peak_pressure != wheelset.axle.right->solution.peak_pressure),
               "the rails differ");
  }

  /// What is told of the axle: a lifted wheel, and a lateral force above the limit of the track.
  BOOST_AUTO_TEST_CASE(test_told)
  {
    const Scene      scene = test::cones();
    WheelsetSolution wheelset;
    wheelset.right.scene = wheelset.left.scene = scene;
    wheelset.right.load                        = 160e3;
    wheelset.axle.lateral                      = 60e3;
    Summary wheel;
    wheel.finished = true;
    wheel.verdict  = "trusted";
    BOOST_TEST(
      same_text(wheelset_summary(scene, wheelset, &wheel, &wheel).verdict, "trusted", "both wheels roll"));
    BOOST_TEST(same_text(wheelset_summary(scene, wheelset, &wheel, &wheel).note, "", "within 63.3 kN"));
    wheelset.axle.lateral = -70e3;
    const Summary lifted  = wheelset_summary(scene, wheelset, &wheel, nullptr);
    BOOST_TEST(same_text(lifted.verdict, "with care", "one of them is lifted"));
    BOOST_TEST(same_text(
      lifted.doubts,
      "The left-hand wheel is lifted: the curve demands more than both wheels hold, and the vehicle "
      "begins to tip over.",
      "and which"));
    // (10 kN + P/3) of Prud'homme (1967)
    BOOST_TEST(
      same_text(lifted.note,
                "The sum of the lateral forces, 70.0 kN, is above the limit after Prud'homme, 63.3 kN: the "
                "track may be shifted.",
                "the limit of the track"));
  }

  /// Y/Q = (tan(gamma) - mu) / (1 + mu tan(gamma)) where the flange slips down the rail as a whole.
  BOOST_AUTO_TEST_CASE(test_nadal)
  {
    Scene scene                      = Scene();
    scene.track.flange_back_distance = 1.370;
    scene.lateral_shift              = -2e-3;
    scene.lateral_creepage           = 0.1;
    scene.friction.at_rest           = 0.3;
    scene.wheel_load                 = 80e3;
    scene.drive                      = Drive::rate;
    const SceneGeometry     geometry = make_geometry(scene);
    const WheelRailSolution result =
      solve_wheel_rail(scene, geometry, scene_load(scene, geometry), scene_offsets(scene));
    std::vector<const WheelRailSolution *> patches{&result};
    for (const WheelRailSolution &other : result.others)
      patches.push_back(&other);
    bool on_flange = false;
    for (const WheelRailSolution *patch : patches)
      if (const double slope = std::tan(-patch->angle), mu = scene.friction.at_rest; slope > 1)
        {
          on_flange = true;
          BOOST_TEST(near(patch->lateral / patch->vertical / ((slope - mu) / (1 + mu * slope)),
                          1,
                          0.01,
                          "Nadal's limit on the flange: ratio"));
        }
    BOOST_TEST(on_flange, "the flange touches");
  }
} // namespace
