// Half-spaces of a wheelset with yaw: some rows of CONTACT's table; mirror images; lateral creepage in its
// place.

#include "halfspace_yaw.h"

#include <cmath>

using namespace wheelrail;
using test::near;

namespace
{
  WheelRailSolution
  solved(const Scene &scene)
  {
    const SceneGeometry geometry = make_geometry(scene);
    return solve_wheel_rail(scene, geometry, scene_load(scene, geometry), scene_offsets(scene));
  }

  /// Without friction a yaw changes nothing but the pose, which is the same for both signs.
  void
  test_frictionless()
  {
    Scene scene;
    scene.wheel_load           = 100e3;
    scene.friction.at_rest     = 0;
    scene.traction_coefficient = 0;
    scene.yaw                  = 40e-3;
    const auto right           = solved(scene);
    scene.yaw                  = -40e-3;
    const auto left            = solved(scene);
    BOOST_TEST(near(
      right.solution.peak_pressure / left.solution.peak_pressure, 1, 1e-4, "peak pressures at +-40 mrad"));
    BOOST_TEST(near(right.lateral, left.lateral, 20, "lateral forces at +-40 mrad, without friction [N]"));
    BOOST_TEST(near(right.vertical, 100e3, 100, "load at 40 mrad, without friction [N]"));
  }

  /// A lateral creepage of minus the yaw slides as the yaw does; the pose of 1 mrad hardly differs.
  void
  test_lateral_creepage()
  {
    Scene scene;
    scene.wheel_load           = 100e3;
    scene.traction_coefficient = 0;
    scene.yaw                  = 1e-3;
    const auto yawed           = solved(scene);
    scene.yaw                  = 0;
    scene.lateral_creepage     = -1e-3;
    const auto moved           = solved(scene);
    BOOST_TEST(
      near(moved.lateral / yawed.lateral, 1, 0.01, "lateral force of a lateral creepage over that of a yaw"));
    BOOST_TEST(near(moved.reference->lateral_creepage, -1e-3, 2e-6, "lateral creepage"));
    // a given spin of the size of the wheel's own changes little, and turning it round changes the force
    scene.halfspace_given_spin = moved.reference->spin;
    const auto same            = solved(scene);
    BOOST_TEST(near(same.reference->spin, moved.reference->spin, 1e-4, "given spin [1/m]"));
    BOOST_TEST(
      near(same.lateral / moved.lateral, 1, 0.05, "lateral force under one spin over that of the wheel's"));
    scene.halfspace_given_spin = -moved.reference->spin;
    BOOST_TEST(std::abs(solved(scene).lateral - moved.lateral) > 2e3,
               "spin of opposite sign changes the force");
  }

  /// The left wheel of a wheelset is the right one of its mirror image.
  void
  test_sides()
  {
    Scene scene;
    scene.wheel_load           = 100e3;
    scene.traction_coefficient = 0.25;
    scene.lateral_shift        = 2e-3;
    scene.yaw                  = 4e-3;
    scene.roll                 = RollMode::from_contact;
    scene.lateral_creepage     = 1e-3;
    scene.left_wheel           = true;
    const auto left            = solved(scene);
    scene.left_wheel           = false;
    const auto right           = solved(scene);
    BOOST_TEST(near(left.roll, -right.roll, 1e-12, "roll of the wheelset, seen from its other wheel [rad]"));
    BOOST_TEST(std::abs(left.lateral - right.lateral) > 1e3, "both wheels have other forces");
    scene.lateral_shift *= -1;
    scene.yaw *= -1;
    scene.lateral_creepage *= -1;
    const auto mirror = solved(scene);
    BOOST_TEST(near(left.lateral, mirror.lateral, 1e-6, "lateral force of the mirror image [N]"));
    BOOST_TEST(near(
      left.solution.peak_pressure / mirror.solution.peak_pressure, 1, 1e-12, "peak of the mirror image"));
  }
} // namespace


BOOST_AUTO_TEST_CASE(halfspace_yaw)
{
  const auto rows = test::read_table("contact_wheel_rail_54E1_yaw.csv");
  for (const std::size_t row : {0, 2, 15})
    test::check_yaw_row(rows.at(row));
  test_frictionless();
  test_lateral_creepage();
  test_sides();
}
