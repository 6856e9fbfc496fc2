// label: long

// Runs of a wheelset with yaw: the left wheel as the mirror image of the right one, a yaw that goes to none,
// and a drift in the place of a yaw.

#include "parallel.h"
#include "yaw_scene.h"

#include <string>

using namespace wheelrail;
using namespace test;

namespace
{
  /// The left wheel of a wheelset with the opposite yaw is the mirror image of the right one.
  BOOST_FIXTURE_TEST_CASE(left_wheel, test::Parallel)
  {
    Scene right = yaw_scene("right"), left = yaw_scene("left");
    right.lateral_shift = 1e-3;
    left.left_wheel     = true;
    left.yaw            = -right.yaw;
    left.lateral_shift  = -right.lateral_shift;
    const Summary a = figures_of_run(right), b = figures_of_run(left);
    for (const char *key : {"lateral_force_N", "max_pressure_Pa", "contact_area_m2", "creepage"})
      BOOST_TEST(
        near(get_figure(b, key) / get_figure(a, key), 1, 1e-5, std::string("left over right wheel: ") + key));
  }

  /// A yaw that is hardly there takes the ways of one, and changes nothing.
  BOOST_FIXTURE_TEST_CASE(hardly_any, test::Parallel)
  {
    Scene straight = yaw_scene("none"), nearly = yaw_scene("hardly any");
    straight.yaw    = 0;
    nearly.yaw      = 1e-8;
    const Summary a = figures_of_run(straight), b = figures_of_run(nearly);
    for (const char *key : {"vertical_force_N", "max_pressure_Pa", "contact_area_m2", "creepage"})
      BOOST_TEST(
        near(get_figure(b, key) / get_figure(a, key), 1, 1e-5, std::string("10 nrad over no yaw: ") + key));
    // 1.4e-4 of the load for each 10 urad
    BOOST_TEST(near((b.lateral_force - a.lateral_force) / a.vertical_force,
                    0,
                    1e-5,
                    "lateral force, difference over the load"));
  }
  /// A wheelset that drifts sideways by minus a yaw slides as one with that yaw; the path aside, 12 um here,
  /// hardly moves the contact.
  BOOST_FIXTURE_TEST_CASE(drifting, test::Parallel)
  {
    Scene turned = yaw_scene("turned"), drift = yaw_scene("drifting");
    drift.yaw              = 0;
    drift.lateral_creepage = -turned.yaw;
    const Summary a = figures_of_run(turned), b = figures_of_run(drift);
    BOOST_TEST(
      near(b.lateral_force / a.lateral_force, 1, 0.01, "lateral force of a drift over that of a yaw"));
    BOOST_TEST(near(get_figure(b, "reference_lateral_creepage") / get_figure(a, "reference_lateral_creepage"),
                    1,
                    2e-3,
                    "lateral creepages"));
    BOOST_TEST(near(b.max_pressure_fitted / a.max_pressure_fitted, 1, 0.01, "peak pressures"));
    const double load = a.vertical_force;
    // the force along the track of the yaw: minus yaw x lateral force
    BOOST_TEST(near((b.longitudinal_force - a.longitudinal_force) / load,
                    turned.yaw * a.lateral_force / load,
                    1e-3,
                    "forces along the track, difference over the load"));
  }
} // namespace
