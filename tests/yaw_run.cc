// Runs of a wheelset with yaw, on coarse cells: its lateral force against half-spaces, no such force without
// friction, and a run that is stopped and goes on.

#include <wheelrail/bodies/body_contact.h>
#include <wheelrail/bodies/run_reference.h>

#include "parallel.h"
#include "yaw_scene.h"

#include <cmath>

using namespace wheelrail;
using namespace test;

namespace
{
  /// The wheel slides sideways by minus its yaw; friction drags it to the track centre, as it does
  /// half-spaces under the same load and in the same pose.
  void
  check_forces(const Scene &scene, const Summary &run)
  {
    const SceneGeometry     geometry = make_geometry(scene);
    const ContactGeometry  &c        = geometry.contact;
    const WheelRailSolution result = solve_wheel_rail(scene, geometry, load_of_run(run), offsets_of_run(run));
    const double            lateral = run.lateral_force;
    BOOST_TEST(lateral > 0.2 * run.vertical_force, "a yaw to the track centre pulls the wheel there");
    // 3 % on cells of 1 mm, in proportion to their size
    BOOST_TEST(near(lateral / result.lateral, 1, 0.12, "lateral force over that of half-spaces"));
    BOOST_TEST(near(
      get_figure(run, "reference_lateral_creepage") / -small_yaw, 1, 0.01, "lateral creepage over -yaw"));
    // the forces act behind the middle of the patch, whose half length is 6 mm
    const double arm_along = c.along, arm_across = c.frame.origin.x - c.axis.middle.x;
    BOOST_TEST(near(get_figure(run, "yaw_moment_Nm"),
                    arm_along * lateral - arm_across * run.longitudinal_force,
                    4e-3 * lateral + 12e-3 * std::abs(run.longitudinal_force),
                    "yaw moment from the forces and the place of the contact [N m]"));
  }

  /// In one go, and stopped before and after the mesh has changed.
  BOOST_FIXTURE_TEST_CASE(rolling, test::Parallel)
  {
    Scene base                    = yaw_scene("parts");
    base.rolling_distance         = 18e-3;
    Scene whole                   = base;
    whole.folder                  = "yaw_one_go";
    const auto [summary, history] = stopped_twice(base, whole);
    for (std::size_t c = 0; c < history.names.size(); ++c)
      if (history.names[c] == "mesh_change_work")
        BOOST_TEST((history.columns[c].front() != history.columns[c].back()), "the mesh has changed");
    check_forces(whole, summary);
  }

  BOOST_FIXTURE_TEST_CASE(without_friction, test::Parallel)
  {
    Scene scene                      = yaw_scene("without friction");
    scene.friction.at_rest           = 0;
    scene.yaw                        = 20e-3;
    const Summary           run      = figures_of_run(scene);
    const SceneGeometry     geometry = make_geometry(scene);
    const WheelRailSolution result = solve_wheel_rail(scene, geometry, load_of_run(run), offsets_of_run(run));
    const double            load   = run.vertical_force;
    BOOST_TEST(near(run.lateral_force / load,
                    result.lateral / load,
                    2e-3,
                    "without friction: the lateral force of inclined pressure alone, over the load"));
    BOOST_TEST(near(run.longitudinal_force / load, 0, 1e-3, "and none along the track"));
    BOOST_TEST(near(run.max_shear_traction, 0, 0, "no shear [Pa]"));
  }
} // namespace
