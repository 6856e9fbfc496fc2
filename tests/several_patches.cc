// Contacts of a wheel that touches its rail in several planes: how they share load and creepage.

#include "manchester.h"
#include "near.h"

#include <wheelrail/bodies/body_contact.h>
#include <wheelrail/bodies/shift_effect.h>
#include <wheelrail/model/scene_geometry.h>
#include <wheelrail/wheel/several_patches.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <string>

using namespace wheelrail;
using test::near;

namespace
{
  constexpr double load = 100e3;

  /// A head with two crowns of 300 mm radius, 15 mm on either side of its middle, that of the field side
  /// lower by `lower` [mm].
  std::string
  two_crowns(const double lower)
  {
    std::string text = "# lateral, height [mm]\n";
    char        line[80];
    for (int i = -360; i <= 360; ++i)
      {
        const double x = 0.1 * i, off = std::abs(x) - 15, beyond = std::max(0., std::abs(x) - 27);
        std::snprintf(line,
                      sizeof(line),
                      "%.3f %.7f\n",
                      x,
                      -off * off / 600 - 0.25 * beyond * beyond - (x > 0 ? lower * std::min(1., x / 5) : 0));
        text += line;
      }
    return text;
  }

  /// A cylinder with a flange.
  std::string
  cylinder()
  {
    std::string text = "# lateral, height [mm]\n";
    char        line[80];
    for (int i = -695; i <= 600; i += 2)
      {
        const double x = 0.1 * i, off = (x + 56) / 9;
        std::snprintf(line, sizeof(line), "%.3f %.7f\n", x, -28 * std::exp(-off * off));
        text += line;
      }
    return text;
  }

  Scene
  crowned_scene(const double lower)
  {
    std::ofstream("several_patches_rail.txt") << two_crowns(lower);
    std::ofstream("several_patches_wheel.txt") << cylinder();
    Scene scene;
    scene.rail_profile           = "several_patches_rail.txt";
    scene.wheel_profile          = "several_patches_wheel.txt";
    scene.track.inclination      = 0;
    scene.wheel_load             = load;
    scene.traction_coefficient   = 0.25;
    scene.halfspace_element_size = 0.6e-3;
    return scene;
  }

  /// Normal force of the elements beyond s [N].
  double
  force_beyond(const HalfspaceSolution &solution, const double s)
  {
    double sum = 0;
    for (int j = 0; j < solution.grid.my; ++j)
      for (int i = 0; i < solution.grid.mx; ++i)
        if (solution.grid.y(j) > s)
          sum += solution.grid.element_area() * solution.pressure[i + solution.grid.mx * j];
    return sum;
  }

  struct Both
  {
    PlaneContact      one;      ///< all of it in one plane, on one grid
    WheelRailSolution together; ///< each patch in its own plane
    double            beyond;   ///< normal force in one plane on the side of the second patch [N]
  };

  Both
  solved(const Scene &scene, const SceneGeometry &geometry, const double traction)
  {
    WheelRailLoad load_of = scene_load(scene, geometry);
    load_of.longitudinal  = traction;
    PlaneContact one(scene, geometry, {}, whole_region(geometry.contact));
    one.press(load_of.force);
    one.carry(load_of);
    const auto regions = separate_regions(geometry, {}, one, -1);
    BOOST_TEST(regions.size() == 2, "two crowns are two regions");
    const double edge = std::isfinite(regions[0].s_max) ? regions[0].s_max : regions[0].s_min;
    const double sum  = force_beyond(one.solution, edge);
    return {one,
            solve_together(scene, geometry, load_of, {}, regions, one),
            edge > 0 ? sum : one.solution.fn - sum};
  }

  /// Two equal crowns carry half of the load each.
  void
  test_equal_crowns()
  {
    const Scene         scene    = crowned_scene(0);
    const SceneGeometry geometry = make_geometry(scene);
    const Both          both     = solved(scene, geometry, 0.1 * load);
    BOOST_TEST(both.together.others.size() == 1, "two crowns are two patches");
    const auto &first = both.together.solution, &second = both.together.others.at(0).solution;
    BOOST_TEST((first.converged() && second.converged()), "the share of equal crowns was found");
    BOOST_TEST(near(first.fn / load, 0.5, 1e-3, "half of the load each: first"));
    BOOST_TEST(near(second.fn / load, 0.5, 1e-3, "half of the load each: second"));
    BOOST_TEST(near(-(first.fx + second.fx) / load, 0.1, 2e-4, "they share what drives"));
  }

  /// With one crown lower than the other, in one plane and in planes of their own: the same forces.
  void
  test_against_one_grid(const double lower, const double traction)
  {
    const Scene         scene    = crowned_scene(lower);
    const SceneGeometry geometry = make_geometry(scene);
    const Both          both     = solved(scene, geometry, traction);
    const std::string   which    = "crown lower by " + std::to_string(lower) + " mm: ";
    const auto         &first = both.together.solution, &second = both.together.others.at(0).solution;
    std::printf("%s second patch carries %.3f kN, on one grid %.3f kN; creepage %.5e, %.5e\n",
                which.c_str(),
                1e-3 * second.fn,
                1e-3 * both.beyond,
                first.xi,
                both.one.solution.xi);
    BOOST_TEST(near(second.fn, both.beyond, 0.002 * load, which + "normal force of the second patch [N]"));
    BOOST_TEST(near(first.fn,
                    both.one.solution.fn - both.beyond,
                    0.002 * load,
                    which + "normal force of the first patch [N]"));
    BOOST_TEST(near(-first.fy - second.fy, -both.one.solution.fy, 0.01 * load, which + "lateral force [N]"));
    BOOST_TEST(near(first.xi / both.one.solution.xi, 1, 0.02, which + "creepage over that on one grid"));
  }

  /// The wheel and the rail of the Manchester benchmark near its flange root: tread and root touch in planes
  /// 9 degrees apart.
  void
  test_tread_and_root()
  {
    Scene scene                      = test::manchester_scene();
    scene.wheel_load                 = 20e3;
    scene.lateral_shift              = -5e-3;
    scene.traction_coefficient       = 0.1;
    scene.halfspace_element_size     = 0.3e-3;
    const SceneGeometry     geometry = make_geometry(scene);
    const WheelRailSolution result   = solve_wheel_rail(scene, geometry, scene_load(scene, geometry), {});
    BOOST_TEST(result.others.size() == 1, "tread and flange root are two patches");
    const WheelRailSolution &root    = result.others.at(0);
    const Summary            summary = halfspace_summary(scene, result);
    BOOST_TEST(summary.finished, "tread and root are solved");
    BOOST_TEST(near(summary.vertical_force / 20e3, 1, 2e-3, "they carry the load"));
    BOOST_TEST(near(summary.longitudinal_force / 20e3, 0.1, 2e-4, "and what drives"));
    BOOST_TEST(near(result.solution.xi, root.solution.xi, 0, "with one creepage"));
    BOOST_TEST(root.angle < result.angle - 0.1, "the root is steeper");
    BOOST_TEST((-root.solution.fx > 0 && -result.solution.fx < 0),
               "the root, with its larger radius, drives, and the tread brakes");
    // the wheel goes down as one body: the approaches differ by the distance of the root at first
    const FurtherPoint &point    = geometry.contact.further.front();
    const double        lowering = result.solution.approach / std::cos(geometry.contact.frame.angle);
    BOOST_TEST(near(root.solution.approach,
                    lowering * std::cos(point.frame.angle) - point.gap,
                    1e-7,
                    "approach of the root [m]"));
    BOOST_TEST(
      near(get_figure(summary, "patch_1_normal_force_N") + get_figure(summary, "patch_2_normal_force_N"),
           summary.normal_force,
           1e-6,
           "normal forces of the summary [N]"));
    BOOST_TEST((grade_of(summary) == Grade::with_care &&
                summary.doubts.find("The surfaces turn by ") != std::string::npos),
               "planes far apart: how they share the load is a matter of pose [" + summary.doubts + "]");
  }

  /// Where the head's corner begins, 0.1 mm of shift decide how sharp the contact is; on the running surface
  /// they do not. The peak of the true bodies is 32 % below that of half-spaces at the first place, 5 % at
  /// the second (doc/theory/bodies.md).
  void
  test_shift_effect()
  {
    Scene scene;
    scene.rail_profile  = "60E1";
    scene.lateral_shift = -5e-3;
    const double corner = shift_effect(scene, make_geometry(scene), 103e3);
    BOOST_TEST((corner > 0.5 && corner < 1), "60E1, shift -5 mm: " + std::to_string(corner));
    BOOST_TEST(shift_effect(scene, make_geometry(scene), 10e3) < corner, "less under a small load");
    const double head = shift_effect(Scene(), make_geometry(Scene()), 103e3);
    BOOST_TEST((head > 0.05 && head < 0.15), "54E1, shift 0: " + std::to_string(head));
  }

  /// Half-spaces under the load of a scene and held against true bodies.
  WheelRailSolution
  held(Scene scene)
  {
    scene.halfspace_bodies       = ContactBodies::half_spaces;
    scene.halfspace_element_size = 0.8e-3;
    const SceneGeometry geometry = make_geometry(scene);
    WheelRailSolution   result =
      solve_wheel_rail(scene, geometry, scene_load(scene, geometry), scene_offsets(scene));
    hold_against_bodies(scene, geometry, result);
    return result;
  }

  /// A lateral force turns head and rim: the half-spaces of a wheel with 5 mrad of yaw are 29 % above.
  void
  test_hold()
  {
    Scene scene;
    BOOST_TEST((std::abs(held(scene).bodies_effect) < 0.06 && held(scene).unheld.empty()),
               "the main scene is held");
    scene.yaw                     = 5e-3;
    const WheelRailSolution yawed = held(scene);
    BOOST_TEST(near(yawed.bodies_effect, 0.29, 0.04, "5 mrad of yaw: over the true bodies"));
    BOOST_TEST(std::isnan(yawed.shift_effect), "and then nothing is guessed");
    scene.yaw                      = 0;
    scene.halfspace_lateral        = 0.1e-3;
    const WheelRailSolution placed = held(scene);
    BOOST_TEST((placed.unheld.find("Half-space/Lateral offset = 0.1 mm: a position given by hand") == 0 &&
                std::isnan(placed.bodies_effect) && placed.shift_effect > 0),
               "a position by hand is not [" + placed.unheld + "]");
    scene.halfspace_lateral = 0;
    scene.both_wheels       = true;
    scene.pose_balances     = true;
    BOOST_TEST(!held(scene).unheld.empty(), "nor is the pose of half-spaces in balance");
  }
} // namespace


BOOST_AUTO_TEST_CASE(several_patches)
{
  test_equal_crowns();
  test_against_one_grid(0.02, 0.1 * load);
  test_tread_and_root();
  test_shift_effect();
  test_hold();
}
