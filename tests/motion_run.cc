// label: long
// Runs that follow a motion, on coarse cells: constant rows are the plain scene, a shift that comes slowly
// ends at the figures of a wheelset that stands there, a run that is stopped goes on bit for bit, and the
// load may go to zero and come back.

#include <wheelrail/commands/scene_row.h>
#include <wheelrail/model/scene_motion.h>

#include "parallel.h"
#include "read_output.h"
#include "yaw_scene.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <string>

using namespace wheelrail;
using namespace test;

namespace
{
  /// Follows the rows of `table`.
  Scene
  following(Scene scene, const std::string &name, const std::string &table)
  {
    scene.title  = "motion, " + name;
    scene.folder = "motion_" + name;
    scene.motion = "./motion_" + name + ".csv";
    std::ofstream(scene.motion) << table;
    return scene_at_start(scene);
  }

  double
  largest_difference(const History &a, const History &b, const std::string &name)
  {
    const auto &x = column(a, name), &y = column(b, name);
    double      most = 0;
    for (std::size_t k = 0; k < x.size(); ++k)
      most = std::max(most, std::abs(x[k] - y[k]));
    return most;
  }

  BOOST_FIXTURE_TEST_CASE(constant_rows, test::Parallel)
  {
    Scene plain         = yaw_scene("plain");
    plain.lateral_shift = 0.3e-3;
    plain.wheel_load    = 90e3;
    plain.velocity      = 30;
    figures_of_run(plain);
    const Scene led = following(plain,
                                "constant",
                                "distance [m],lateral shift [mm],yaw [mrad],load [kN],velocity [m/s]\n"
                                "0,0.3,2,90,30\n1,0.3,2,90,30\n2,0.3,2,90,30\n");
    figures_of_run(led);
    const History a = read_history(plain.folder + "/history.h5"),
                  b = read_history(led.folder + "/history.h5");
    for (const char *const force : {"vertical_force", "longitudinal_force", "lateral_force"})
      BOOST_TEST(
        near(largest_difference(a, b, force), 0, 5, std::string("constant rows: ") + force + " [N]"));
    BOOST_TEST(near(largest_difference(a, b, "creepage"), 0, 1e-8, "constant rows: creepage"));
    BOOST_TEST(near(largest_difference(a, b, "energy_residual"), 0, 1e-4, "constant rows: energies [J]"));
  }

  /// A wheelset that is moved aside and unloaded slowly presses in the end as one that always stood there.
  /// Slowly: in several periods of its bending to the side, which a stout disc makes short. Without
  /// friction, which would hold it back for metres.
  BOOST_FIXTURE_TEST_CASE(slow_shift, test::Parallel)
  {
    Scene base                = yaw_scene("shifted");
    base.cell_size            = 3e-3;
    base.coarse_cell_size     = 12e-3;
    base.yaw                  = 0;
    base.velocity             = 20 / 3.6;
    base.wheel.disc_thickness = 0.06;
    base.friction.at_rest     = 0;
    base.energy_limit         = 0.5; // see below
    base.rolling_distance     = 80e-3;
    base.averaging_distance   = 30e-3;
    const Scene led           = following(base,
                                "slow_shift",
                                "distance [mm],lateral shift [mm],load [kN]\n"
                                          "0,0,100\n5,0,100\n45,0.5,90\n80,0.5,90\n100,0.5,90\n");
    BOOST_TEST(run(led, false) == 0, led.title + ": the run ends");
    const Summary moved    = read_summary(led.folder + "/summary.json");
    Scene         there    = base;
    there.lateral_shift    = 0.5e-3;
    there.wheel_load       = 90e3;
    there.rolling_distance = 40e-3;
    const Summary stood    = figures_of_run(there);
    // facets of 3 mm that slide over each other sideways are no smooth surfaces: contact gives or takes work
    // (on cells of 1 mm a fortieth of it); all other works are booked
    const History history  = read_history(led.folder + "/history.h5");
    const auto   &residual = column(history, "energy_residual"),
               &scheme     = column(history, "contact_scheme_energy");
    BOOST_TEST(near((residual.back() - scheme.back()) / column(history, "strain_energy").back(),
                    0,
                    1e-3,
                    "energy missed but for that of discrete contact, over the strain energy"));
    BOOST_TEST(std::abs(column(history, "speed_hold_work").back()) > 0.5,
               "the wheelset is moved against the contact");
    BOOST_TEST(near(moved.vertical_force / stood.vertical_force, 1, 5e-3, "vertical force"));
    BOOST_TEST(
      near((moved.lateral_force - stood.lateral_force) / stood.vertical_force, 0, 2e-3, "lateral force"));
    BOOST_TEST(
      near(moved.max_pressure / stood.max_pressure, 1, 0.12, "peak pressure, of nodes at other places"));
    BOOST_TEST(near(moved.contact_area / stood.contact_area, 1, 0.03, "area"));
    BOOST_TEST(near(get_figure(moved, "lateral_shift_m"), 0.5e-3, 1e-12, "shift of the means [m]"));
    BOOST_TEST(
      near((get_figure(moved, "relative_lateral_m") - get_figure(stood, "relative_lateral_m")) / 1e-3,
           0,
           0.02,
           "pose against the led wheelset [mm]"));
  }

  /// All columns, in one go, and stopped before and after the mesh has changed.
  BOOST_FIXTURE_TEST_CASE(going_on, test::Parallel)
  {
    Scene base            = yaw_scene("all");
    base.rolling_distance = 18e-3;
    const std::string table =
      "time [ms],lateral shift [mm],roll [mrad],yaw [mrad],load [kN],velocity [km/h],traction\n"
      "0,0,0,1,100,140,0.1\n1,0.02,0.1,1.2,110,141,0.2\n2,0.1,0,1,90,139,0.1\n";
    const Scene parts             = following(base, "parts", table);
    Scene       whole             = parts;
    whole.folder                  = "motion_one_go";
    const auto [summary, history] = stopped_twice(parts, whole);
    BOOST_TEST(near(column(history, "rolled_distance").back() / 18e-3, 1, 1e-6, "way rolled"));
    const SceneMotion motion(parts);
    BOOST_TEST(near(column(history, "time").back() / motion.duration(18e-3), 1, 1e-9, "its time"));
    BOOST_TEST(near(column(history, "yaw").back(), motion.at(18e-3).yaw, 1e-9, "yaw at the end [rad]"));
    BOOST_TEST(
      near(column(history, "wheel_load").back() / motion.at(18e-3).wheel_load, 1, 1e-5, "load at the end"));
  }

  BOOST_FIXTURE_TEST_CASE(without_load, test::Parallel)
  {
    Scene base              = yaw_scene("lifted");
    base.yaw                = 0;
    base.velocity           = 20 / 3.6;
    base.rolling_distance   = 150e-3;
    base.averaging_distance = 46e-3; // two periods of the wheel on its contact, after it has landed
    base.rail_length        = 0.6;
    const Scene led =
      following(base, "no_load", "distance [mm],load [kN]\n0,100\n5,100\n45,0\n50,0\n90,100\n150,100\n");
    const Summary summary = figures_of_run(led);
    const History history = read_history(led.folder + "/history.h5");
    const auto   &force   = column(history, "vertical_force");
    BOOST_TEST(*std::min_element(force.begin(), force.end()) < 1e3, "hardly a force where there is no load");
    BOOST_TEST(near(summary.vertical_force / 100e3, 1, 0.05, "the load is back"));
  }
} // namespace
