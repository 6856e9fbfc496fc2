// Both wheels of case of the Manchester contact benchmark against CONTACT, and its flange contact, for
// which there is no table, against the balance of a patch that slides.

#include "manchester.h"
#include "reference_table.h"

#include <wheelrail/bodies/body_contact.h>
#include <wheelrail/model/scene_geometry.h>
#include <wheelrail/vehicle/wheelset_contact.h>
#include <wheelrail/wheel/halfspace_case.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

using namespace wheelrail;
using test::near;

namespace
{
  constexpr double load = 10e3;

  Scene
  benchmark_scene()
  {
    Scene scene                  = test::manchester_scene();
    scene.velocity               = 2;
    scene.wheel_load             = load;
    scene.friction.at_rest       = 0.3;
    scene.halfspace_element_size = 0.2e-3;
    scene.halfspace_spin         = HalfspaceSpin::contact;
    scene.roll                   = RollMode::given;
    scene.drive                  = Drive::rate;
    for (MaterialData *steel : {&scene.rail_material, &scene.wheel_material})
      {
        steel->youngs_modulus = 2 * 82e9 * 1.28;
        steel->poissons_ratio = 0.28;
      }
    return scene;
  }

  /// Peak 0.5 %, area 1 %, forces 1 % of the load, creepages 1 %, angle 1.5 mrad, place 0.1 mm across and 0.5
  /// mm along the rail.
  void
  check_row(const std::vector<std::string> &row)
  {
    const auto   number = [&](const int column) { return std::stod(row[column]); };
    const bool   left   = row[0] == "left";
    const double mirror = left ? 1 : -1; // the modelled wheel is the left one of the file in the mirror
    Scene        scene  = benchmark_scene();
    scene.lateral_shift = mirror * 1e-3 * number(2);
    scene.yaw           = mirror * 1e-3 * number(3);
    scene.roll_angle    = -mirror * 1e-3 * number(4);
    const SceneGeometry geometry = make_geometry(scene);
    // the wheelset turns with this rate in the benchmark
    scene.creepage = -number(7) * geometry.contact.rolling_radius * std::cos(scene.yaw) / scene.velocity - 1;
    const WheelRailSolution result =
      solve_wheel_rail(scene, geometry, scene_load(scene, geometry), scene_offsets(scene));
    const HalfspaceSolution &s     = result.solution;
    const ContactReference  &at    = *result.reference;
    const std::string        which = row[0] + " wheel, shift " + row[2] + " mm: ";

    BOOST_TEST((s.converged() && !s.touches_grid_edge), which + "converged");
    BOOST_TEST(near(1e-6 * s.peak_pressure / number(36), 1, 0.005, which + "peak pressure over CONTACT's"));
    BOOST_TEST(near(1e6 * s.area / number(40), 1, 0.01, which + "area over CONTACT's"));
    BOOST_TEST(near(1e-6 * s.peak_shear / number(39), 1, 0.01, which + "peak shear over CONTACT's"));
    const double few = 0.01 * load;
    BOOST_TEST(near(s.fn, number(21), few, which + "normal force [N]"));
    BOOST_TEST(near(s.fx, number(25), few, which + "force along the rail [N]"));
    BOOST_TEST(near(-result.lateral, mirror * number(26), few, which + "lateral force on the rail [N]"));
    BOOST_TEST(near(result.vertical, load, 0.002 * load, which + "vertical force [N]"));
    BOOST_TEST(near(-at.driving, number(28), few, which + "force along the wheelset, on the rail [N]"));
    BOOST_TEST(near(-at.across, mirror * number(29), few, which + "force along the axle, on the rail [N]"));
    // a rolling radius that is 2 um off is a creepage of 4e-6
    BOOST_TEST(
      near(at.creepage, number(31), std::max(0.01 * std::abs(number(31)), 4e-6), which + "creepage"));
    BOOST_TEST(near(-at.lateral_creepage,
                    mirror * number(32),
                    0.01 * std::abs(number(32)) + 1e-9,
                    which + "lateral creepage"));
    BOOST_TEST(near(mirror * at.spin / (1e3 * number(33)), 1, 0.01, which + "spin over CONTACT's"));
    BOOST_TEST(near(at.angle, mirror * number(20), 1.5e-3, which + "contact angle [rad]"));
    BOOST_TEST(near(at.place.x, 0.75 + mirror * 1e-3 * number(13), 0.1e-3, which + "lateral place [m]"));
    BOOST_TEST(near(at.along, 1e-3 * number(12), 0.5e-3, which + "place along the track [m]"));
    BOOST_TEST(near(at.ahead, 1e-3 * number(17), 0.5e-3, which + "place ahead of the axle [m]"));
  }

  /// Both wheels on one axle that turns with the benchmark's rate, half as fine: forces 1 % of the load,
  /// creepages 2 %.
  void
  check_axle(const std::vector<std::string> &left_row, const std::vector<std::string> &right_row)
  {
    const auto number            = [&](const int column) { return std::stod(right_row[column]); };
    Scene      scene             = benchmark_scene();
    scene.halfspace_element_size = 0.4e-3;
    scene.both_wheels            = true;
    scene.lateral_shift          = -1e-3 * number(2);
    scene.yaw                    = -1e-3 * number(3);
    scene.roll_angle             = 1e-3 * number(4);
    const Scene right            = wheel_of_wheelset(scene, false);
    scene.creepage = -number(7) * make_geometry(right).contact.forward_radius / scene.velocity - 1;
    const WheelsetSolution wheelset = solve_wheelset(wheel_of_wheelset(scene, false),
                                                     wheel_of_wheelset(scene, true),
                                                     read_wheelset_profiles(scene),
                                                     std::nullopt,
                                                     2);
    BOOST_TEST(
      near(wheelset.axle.rate * scene.velocity, -number(7), 1e-9, "turning rate of the axle [rad/s]"));
    const double few = 0.01 * load;
    for (const bool is_left : {false, true})
      {
        const auto              &row    = is_left ? left_row : right_row;
        const WheelRailSolution &wheel  = is_left ? *wheelset.axle.left : *wheelset.axle.right;
        const double             mirror = is_left ? 1 : -1;
        const std::string        which  = "on the axle, " + row[0] + " wheel, shift " + row[2] + " mm: ";
        const auto               value  = [&](const int column) { return std::stod(row[column]); };
        BOOST_TEST(near(wheel.solution.fx, value(25), few, which + "force along the rail [N]"));
        BOOST_TEST(near(-wheel.lateral, mirror * value(26), few, which + "lateral force on the rail [N]"));
        BOOST_TEST(near(wheel.reference->creepage,
                        value(31),
                        std::max(0.02 * std::abs(value(31)), 4e-6),
                        which + "creepage"));
      }
    const auto sum = [&](const int column) {
      return std::stod(left_row[column]) + std::stod(right_row[column]);
    };
    BOOST_TEST(near(wheelset.axle.lateral, sum(26), 2 * few, "sum of the lateral forces [N]"));
  }

  /// The benchmark's wheelset off to the flange.
  Scene
  flange_scene(const double shift, const double yaw)
  {
    Scene scene                = benchmark_scene();
    scene.roll                 = RollMode::none;
    scene.drive                = Drive::torque;
    scene.traction_coefficient = 0;
    scene.lateral_shift        = -shift;
    scene.yaw                  = -yaw;
    return scene;
  }

  /// Just before the flange carries all: root and flange share the load.
  void
  check_root_and_flange()
  {
    const Scene             scene    = flange_scene(6.5e-3, 15.6e-3);
    const SceneGeometry     geometry = make_geometry(scene);
    const WheelRailSolution root =
      solve_wheel_rail(scene, geometry, scene_load(scene, geometry), scene_offsets(scene));
    BOOST_TEST(root.others.size() == 1, "root and flange: two patches");
    if (root.others.empty())
      return;
    const WheelRailSolution &flange = root.others[0];
    for (const WheelRailSolution *patch : {&root, &flange})
      BOOST_TEST((patch->solution.converged() && !patch->solution.touches_grid_edge),
                 "root and flange: answered");
    BOOST_TEST(
      near(root.vertical + flange.vertical, load, 0.002 * load, "root and flange: vertical force [N]"));
    BOOST_TEST((std::abs(flange.angle) > 1.1 && std::abs(root.angle) < 0.7), "root and flange: angles");
  }

  /// On the flange all of the patch slides and the normal force is far more than the load.
  void
  check_flange(const double shift, const double yaw)
  {
    const Scene              scene    = flange_scene(shift, yaw);
    const SceneGeometry      geometry = make_geometry(scene);
    const SectionOffsets     offsets  = scene_offsets(scene);
    const WheelRailSolution  result = solve_wheel_rail(scene, geometry, scene_load(scene, geometry), offsets);
    const HalfspaceSolution &s      = result.solution;
    const std::string        which  = "flange, shift " + std::to_string(1e3 * shift) + " mm: ";

    BOOST_TEST((s.converged() && !s.touches_grid_edge), which + "answered");
    BOOST_TEST(std::abs(result.angle) > 1.1, which + "steep");
    BOOST_TEST(near(result.vertical, load, 0.002 * load, which + "vertical force [N]"));
    const double fx = s.fx, friction = std::sqrt(fx * fx + s.fy * s.fy);
    BOOST_TEST(near(friction / (scene.friction.at_rest * s.fn), 1, 0.01, which + "all of it slides"));
    const double across = std::sqrt(std::max(0., 0.09 * s.fn * s.fn - fx * fx));
    BOOST_TEST(near((s.fn * std::cos(result.angle) + across * std::abs(std::sin(result.angle))) / load,
                    1,
                    0.01,
                    which + "balance of the patch that slides"));
    BOOST_TEST(s.fn > 1.4 * load, which + "normal force over the load");
    // the patch of that normal force, laid for it from the first
    const HalfspacePressure pressed = halfspace_pressure(scene, geometry, s.fn, offsets);
    BOOST_TEST(near(s.peak_pressure / pressed.peak, 1, 0.005, which + "peak pressure of the normal force"));
  }
} // namespace


BOOST_AUTO_TEST_CASE(halfspace_manchester)
{
  const auto rows = test::read_table("contact_manchester_a22.csv");
  for (const auto &row : rows)
    check_row(row);
  for (const auto &left : rows)
    for (const auto &right : rows)
      if (left[0] == "left" && right[0] == "right" && left[1] == right[1])
        check_axle(left, right);
  check_root_and_flange();
  check_flange(6.6e-3, 15.84e-3);
  check_flange(7e-3, 16.8e-3);
}
