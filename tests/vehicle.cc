// Rows of a vehicle simulation in half-spaces, and the messages of the command.

#include "messages.h"
#include "motion_table.h"

#include <wheelrail/application/command_line.h>
#include <wheelrail/base/interrupt.h>
#include <wheelrail/bodies/body_contact.h>
#include <wheelrail/commands/scene_row.h>
#include <wheelrail/vehicle/vehicle.h>
#include <wheelrail/vehicle/vehicle_rows.h>
#include <wheelrail/vehicle/wheelset_figures.h>
#include <wheelrail/wheel/halfspace_case.h>

#include <cmath>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

using namespace wheelrail;
using test::File;
using test::near;

namespace
{
  /// Those of the command itself.
  BOOST_AUTO_TEST_CASE(test_command)
  {
    const File        file("time [s]\n0\n");
    const std::string scene = WHEELRAIL_SOURCE_DIR "/prm/rolling.prm";
    const auto        said  = [](const Arguments &arguments) {
      std::ostringstream out;
      return test::message_of([&]() { execute(arguments, {}, out); });
    };
    BOOST_TEST(test::same_text(
      said({"vehicle", scene}),
      "vehicle needs a motion file, such as ./wheelrail vehicle prm/rolling.prm prm/s_curve.csv",
      "no motion"));
    BOOST_TEST(test::same_text(
      said({"vehicle", scene, file.path(), "--set", "Half-space/Undeformed distance = hertz"}),
      "vehicle takes the distance of wheel and rail: set Half-space/Undeformed distance = profiles",
      "a distance that is given"));
    BOOST_TEST(test::same_text(
      said({"run", scene, "--row", file.path() + ":1", "--set", "Wheelset/Motion = " + file.path()}),
      "--row and Wheelset/Motion: a scene has one row, or follows a motion; leave one out",
      "a row and a motion"));
    BOOST_TEST(test::same_text(said({"halfspace", scene, "--beside", file.path()}),
                               "--beside draws points beside a creep curve: give --creep-curve, too",
                               "points beside nothing"));
    std::ostringstream out;
    const File         any_order("load [kN],distance [m]\n80,3\n");
    execute({"vehicle", scene, any_order.path(), "--bodies", "half-spaces", "--no-pictures"}, {}, out);
    BOOST_TEST((out.str().find("row 1, distance 3 m") != std::string::npos),
               "the place of a row: " + out.str());
    // whole wheelsets
    const std::string both = "Wheelset/Wheels = both";
    BOOST_TEST(
      test::same_text(said({"halfspace", scene, "--set", both, "--creep-curve", "spin 0,1 1/m"}),
                      "--creep-curve takes one wheel; Wheelset/Wheels = both asks for two: set it to one",
                      "a creep curve of two wheels"));
    {
      const File cant("distance [m],cant [mm]\n0,100\n");
      BOOST_TEST(test::same_text(
        said({"vehicle", scene, cant.path()}),
        "the column cant shares the load of an axle between two wheels: give --both-wheels, or leave it out",
        "a cant under one wheel"));
    }
    const File loads("distance [m],load right [kN],load left [kN]\n0,80,60\n");
    BOOST_TEST(test::same_text(
      said({"vehicle", scene, loads.path(), "--both-wheels", "--set", "Track/Cant = 100 mm"}),
      "Track/Cant = 100 mm: the rows have the loads of both wheels already; write none, or the column "
      "load in their place",
      "a cant beside loads"));
    BOOST_TEST(test::same_text(
      said({"run", scene, "--wheelset", "--row", loads.path() + ":1"}),
      "--row: the row has a load for each wheel, the scene one for both; write the column load in "
      "their place, and cant where the curve shares it",
      "a row with two loads as a scene"));
    BOOST_TEST(test::same_text(
      said({"run",
            scene,
            "--wheelset",
            "--set",
            "Wheelset/Side = left",
            "--set",
            "Track/Cant = 0 mm",
            "--set",
            "Track/Radius = 200 m"}),
      "--wheelset: the left-hand wheel is lifted in this curve; run the other side, or change "
      "radius, cant or "
      "velocity",
      "a lifted wheel"));
    const std::string unheld = said({"run",
                                     scene,
                                     "--wheelset",
                                     "--set",
                                     "Half-space/Element size = 3 mm",
                                     "--set",
                                     "Contact/Friction coefficient = 0",
                                     "--set",
                                     "Wheelset/Pose = equilibrium",
                                     "--set",
                                     "Track/Radius = 500 m",
                                     "--set",
                                     "Track/Cant = 0 mm",
                                     "--set",
                                     "Wheelset/Velocity = 500 km/h",
                                     "--set",
                                     "Wheelset/Centre of gravity height = 0 m"});
    BOOST_TEST(
      (unheld.rfind("--wheelset: No shift and yaw were found at which the forces on the wheelset balance: ",
                    0) == 0 &&
       unheld.find("are left over. Look at the wheelset with the command halfspace first") !=
         std::string::npos),
      "a curve that no flange holds: " + unheld);
    BOOST_TEST(read_motion_file(WHEELRAIL_SOURCE_DIR "/prm/s_curve.csv").rows() > 100,
               "the curve of prm/ can be read");
  }

  /// One row as a scene.
  BOOST_AUTO_TEST_CASE(test_scene_of_row)
  {
    const File file(
      "time [s],lateral shift [mm],yaw [mrad],load [kN],torque [kN m]\n"
      "0,1,2,90,4.6\n"
      "1,2,3,0,0\n");
    const Scene at = scene_of_row({}, file.path() + ":1");
    BOOST_TEST(near(at.lateral_shift, 1e-3, 0, "shift of the row [m]"));
    BOOST_TEST(near(at.yaw, 2e-3, 0, "yaw of the row [rad]"));
    BOOST_TEST(near(at.wheel_load, 90e3, 0, "load of the row [N]"));
    // the radius at the contact is the nominal one within a millimetre
    BOOST_TEST(
      near(at.traction_coefficient, 4.6e3 / (0.46 * 90e3), 3e-4, "traction coefficient of a torque"));
    const auto said = [&](const std::string &place) {
      return test::message_of([&]() { scene_of_row({}, place); });
    };
    for (const char *place : {"rows.csv", ":1", "rows.csv:", "rows.csv:one"})
      BOOST_TEST(
        test::same_text(said(place),
                        std::string("--row \"") + place +
                          "\": write a file of rows and the number of one, such as prm/s_curve.csv:25",
                        "a place without a number"));
    BOOST_TEST(test::same_text(said(file.path() + ":3"),
                               "--row \"" + file.path() + ":3\": the file has the rows 1 to 2",
                               "a row beyond the file"));
    BOOST_TEST(
      test::same_text(said(file.path() + ":2"),
                      "--row \"" + file.path() + ":2\": without a load there is no contact; take another row",
                      "a row without a load"));
  }

  /// Rows without a column that drives: they roll freely though the scene drives, unless they are to.
  BOOST_AUTO_TEST_CASE(test_free_rows)
  {
    const File        file("time [s], lateral shift [mm], load [kN]\n0, 0, 90\n");
    const std::string scene  = WHEELRAIL_SOURCE_DIR "/prm/rolling.prm"; // traction 0.25
    const auto        answer = [&](std::vector<std::string> more) {
      std::ostringstream out;
      Arguments          line = {
                 "vehicle", scene, file.path(), "--no-pictures", "--set", "Half-space/Element size = 2 mm"};
      line.insert(line.end(), {"--set", "Output/Folder = vehicle_rows"});
      line.insert(line.end(), more.begin(), more.end());
      BOOST_TEST(test::near(execute(line, {}, out), 0, 0, "exit code"));
      return out.str();
    };
    const auto force = []() {
      std::ifstream table("vehicle_rows-vehicle/vehicle.csv");
      std::string   keys, values, key, value;
      std::getline(table, keys);
      std::getline(table, values);
      std::istringstream key_words(keys), value_words(values);
      while (std::getline(key_words, key, ',') && std::getline(value_words, value, ','))
        if (key == "right_wheelset_longitudinal_force_N")
          return std::stod(value);
      return std::nan("");
    };
    const std::string none = "note: no torque, traction or creepage in the rows: the wheels ";
    BOOST_TEST((answer({}).rfind(
                  none + "roll freely, whatever the scene says; --traction from scene drives them as it "
                         "says\n",
                  0) == 0),
               "the screen says that they roll freely");
    BOOST_TEST(near(force(), 0, 1, "and so they do [N]"));
    const std::vector<std::vector<std::string>> options = {{"--traction", "from", "scene"},
                                                           {"--traction", "from scene"}};
    for (const auto &words : options)
      BOOST_TEST(answer(words).rfind(
                   none + "are driven as the scene says, Wheelset/Traction coefficient = 0.25\n", 0) == 0,
                 "the screen says what drives them");
    BOOST_TEST(near(force(), 0.25 * 90e3, 30, "and it does [N]"));
    BOOST_TEST(near(scene_of_row(read_scene(scene, {}).scene, file.path() + ":1").traction_coefficient,
                    0,
                    0,
                    "a row as a scene, the same"));
    BOOST_TEST(near(scene_of_row(read_scene(scene, {}).scene, file.path() + ":1", RowDrive::from_scene)
                      .traction_coefficient,
                    0.25,
                    0,
                    "and driven"));
    const auto said = [](const Arguments &arguments) {
      std::ostringstream out;
      return test::message_of([&]() { execute(arguments, {}, out); });
    };
    BOOST_TEST(test::same_text(
      said({"vehicle", scene, file.path(), "--traction", "0.1"}),
      "--traction 0.1: write --traction from scene, or leave it out for rows that roll freely",
      "a value"));
    BOOST_TEST(test::same_text(
      said({"halfspace", scene, "--traction", "from", "scene"}),
      "--traction says what drives a row: give --row, too, or set Wheelset/Traction coefficient",
      "without a row"));
    const File driven("time [s], torque [kN m]\n0, 1\n");
    BOOST_TEST(test::same_text(
      said({"vehicle", scene, driven.path(), "--traction", "from", "scene"}),
      "--traction from scene: the rows have a torque, traction or creepage of their own; leave the "
      "option or the column out",
      "two drives"));
  }

  BOOST_AUTO_TEST_CASE(test_rows)
  {
    Scene scene;
    scene.halfspace_bodies           = ContactBodies::half_spaces;
    scene.wheel_load                 = 90e3;
    scene.traction_coefficient       = 0;
    scene.halfspace_element_size     = 0.8e-3;
    scene.track.flange_back_distance = 1.37;
    const File file(
      "distance [m]; lateral shift [mm]; yaw [mrad]; load [kN]; torque [kN m]\r\n"
      "0; 0; 0; 100; 0\r\n1; 0.5; 2; 0; 0\r\n# remark\r\n2; 1; 3; 80; 4.6\r\n3; 11.9; 0; 80; 0\r\n");
    const MotionFile motion = read_motion_file(file.path());
    BOOST_TEST((motion.rows() == 4 && std::abs((*motion.find(MotionQuantity::yaw))[2] - 3e-3) < 1e-15),
               "four rows");
    const WheelsetProfiles profiles = read_wheelset_profiles(scene);
    const VehicleWheel     wheel    = solve_vehicle(scene, profiles, motion).wheels.front();
    BOOST_TEST((wheel.faults[0].empty() && wheel.faults[1].empty() && wheel.faults[2].empty()),
               "three rows have contact");
    BOOST_TEST((wheel.faults[3].find("no contact point") != std::string::npos),
               "the last one has none, and says so");
    BOOST_TEST(near(wheel.rows[1].normal_force, 0, 0, "no load, no force [N]"));
    BOOST_TEST(near(wheel.rows[0].vertical_force, 100e3, 200, "load of the first row [N]"));

    // interrupted and gone on with: the same bits
    std::filesystem::remove("rows.kept");
    try
      {
        VehicleRows kept("rows.kept", "a scene", motion);
        solve_vehicle(scene, profiles, motion, &kept, [&]() {
          if (kept.count() == 3)
            throw Interrupted();
        });
      }
    catch (const Interrupted &)
      {
      }
    std::ofstream("rows.kept", std::ios::app) << "\n{\"row\": 0, \"giv"; // torn
    VehicleRows kept("rows.kept", "a scene", motion);
    BOOST_TEST(kept.count() >= 3, "three rows are kept, or one more that another thread had");
    const std::size_t  first = kept.restored();
    std::size_t        again = 0;
    const VehicleWheel gone_on =
      solve_vehicle(scene, profiles, motion, &kept, [&]() { ++again; }).wheels.front();
    bool identical = gone_on.faults == wheel.faults;
    for (std::size_t k = 0; k < motion.rows(); ++k)
      {
        Summary one = gone_on.rows[k], other = wheel.rows[k];
        one.wall_time = other.wall_time = 0; // of rows whose stresses are asked for, which are solved again
        identical                       = identical && summary_as_text(one) == summary_as_text(other);
      }
    BOOST_TEST((identical && again < 4), "gone on with " + std::to_string(again) + " rows to the same bits");
    BOOST_TEST((first + again == motion.rows()),
               "progress counts no row twice, though some are solved again");
    BOOST_TEST(test::same_text(
      test::message_of([&]() { VehicleRows("rows.kept", "another", motion); }),
      "\"rows.kept\": rows of another scene, or of another version of the program, from a call that "
      "was interrupted. Set the entries back to continue with them, choose another Output/Folder, or give "
      "--overwrite to start anew.",
      "rows of another scene"));

    // lines of another content than they were written with are solved again, a file without a head is refused
    std::string lines;
    std::getline(std::ifstream("rows.kept"), lines, '\0');
    for (std::size_t at = 0; (at = lines.find("max_pressure_Pa", at + 1)) != std::string::npos;)
      lines[at + 20] ^= 1;
    std::ofstream("rows.kept") << lines;
    BOOST_TEST(VehicleRows("rows.kept", "a scene", motion).count() == 0,
               "rows with another digit are not taken");
    for (const char *const text : {"", "{\"scene\": \"a sc", "[1, 2]\n"})
      {
        std::ofstream("rows.kept") << text;
        BOOST_TEST(
          (test::message_of([&]() {
             VehicleRows("rows.kept", "a scene", motion);
           }).find("\"rows.kept\": rows of an unknown scene, from a call that was interrupted") == 0),
          std::string("rows in a file that is damaged: ") + text);
      }

    // a row is the scene with its values
    Scene row                    = scene;
    row.lateral_shift            = 1e-3;
    row.yaw                      = 3e-3;
    row.wheel_load               = 80e3;
    const SceneGeometry geometry = make_geometry(row, profiles.right);
    WheelRailLoad       load     = scene_load(row, geometry);
    load.longitudinal            = 4600 / geometry.contact.rolling_radius;
    const WheelRailSolution own  = solve_wheel_rail(row, geometry, load, scene_offsets(row));
    BOOST_TEST(near(wheel.rows[2].lateral_force, own.lateral, 1e-6, "lateral force of the third row [N]"));
    BOOST_TEST(near(get_figure(wheel.rows[2], "wheelset_longitudinal_force_N"),
                    10e3,
                    100,
                    "its torque over the radius [N]"));
    BOOST_TEST(get_figure(wheel.rows[2], "largest_von_mises_Pa") > 3e8,
               "stresses of the rows with the largest pressures");

    // the left wheel sees the motion in a mirror
    row.left_wheel            = true;
    const SceneGeometry other = make_geometry(row, profiles.right);
    load.longitudinal         = 4600 / other.contact.rolling_radius;
    const auto left           = solve_wheel_rail(row, other, load, scene_offsets(row));
    scene.rigid_axle          = false;
    scene.both_wheels         = true;
    const VehicleResult both  = solve_vehicle(scene, profiles, motion);
    BOOST_TEST(std::isnan(get_figure(both.axle[2], "axle_pitch_rate_rad_per_s")),
               "independent wheels have no one rate");
    BOOST_TEST(
      near(both.wheels[0].rows[2].lateral_force, own.lateral, 1e-9, "independent wheels: the right one [N]"));
    BOOST_TEST(near(both.wheels[1].rows[2].lateral_force, left.lateral, 1e-9, "and the left one [N]"));
  }

  /// Both wheels on their axle: each row has its loads and its curve, and its torque is that of the axle.
  BOOST_AUTO_TEST_CASE(test_axle_rows)
  {
    Scene scene                  = {};
    scene.halfspace_bodies       = ContactBodies::half_spaces;
    scene.halfspace_element_size = 0.8e-3;
    scene.both_wheels            = true;
    const File file(
      "distance [m],lateral shift [mm],load right [kN],load left [kN],torque [kN m],radius [m]\n"
      "0,-2,100,60,0,0\n1,-2,100,60,4,300\n2,-2,100,0,0,0\n");
    const MotionFile       motion   = read_motion_file(file.path());
    const WheelsetProfiles profiles = read_wheelset_profiles(scene);
    const VehicleResult    both     = solve_vehicle(scene, profiles, motion);
    BOOST_TEST((both.axle.size() == 3 && both.wheels.size() == 2), "three rows of two wheels on one axle");
    const auto force = [&](const std::size_t wheel, const std::size_t row) {
      return get_figure(both.wheels[wheel].rows[row], "wheelset_longitudinal_force_N");
    };
    BOOST_TEST(
      near(both.wheels[0].rows[0].vertical_force / 100e3, 1, 1.1e-3, "load of the right wheel: ratio"));
    BOOST_TEST(
      near(both.wheels[1].rows[0].vertical_force / 60e3, 1, 1.1e-3, "load of the left wheel: ratio"));
    BOOST_TEST(near(get_figure(both.axle[0], "axle_load_N"), 160e3, 0, "load of the axle [N]"));
    BOOST_TEST(near((force(0, 0) + force(1, 0)) / 160e3, 0, 1e-3, "what one wheel drives the other brakes"));
    BOOST_TEST(force(0, 0) > 1e3, "the wheel near its flange drives on a straight track [N]");
    BOOST_TEST(near(get_figure(both.axle[1], "axle_torque_Nm"), 4e3, 10, "torque of the axle [N m]"));
    BOOST_TEST(force(0, 1) < force(0, 0), "in a curve to the left the outer wheel has farther to go");
    BOOST_TEST(near(both.wheels[1].rows[2].normal_force, 0, 0, "a wheel without load [N]"));
    // one wheel that does not touch is enough
    scene.track.flange_back_distance = 1.37;
    const File          off("distance [m],lateral shift [mm],load [kN]\n0,11.9,80\n");
    const VehicleResult none = solve_vehicle(scene, profiles, read_motion_file(off.path()));
    BOOST_TEST((none.wheels[0].faults[0].find("no contact point") != std::string::npos &&
                std::isnan(get_figure(none.axle[0], "axle_torque_Nm"))),
               "a row that does not touch has no figures, and says so");
  }

  /// Rows of radius and cant: the loads that follow, and a wheel that is lifted.
  BOOST_AUTO_TEST_CASE(test_cant_rows)
  {
    Scene scene                  = {};
    scene.halfspace_bodies       = ContactBodies::half_spaces;
    scene.halfspace_element_size = 0.8e-3;
    scene.both_wheels            = true;
    const File file(
      "distance [m],load [kN],velocity [km/h],radius [m],cant [mm]\n"
      "0,80,72,500,0\n1,80,72,-500,0\n2,80,200,500,0\n");
    const VehicleResult vehicle =
      solve_vehicle(scene, read_wheelset_profiles(scene), read_motion_file(file.path()));
    const auto load = [&](const std::size_t wheel, const std::size_t row) {
      return vehicle.wheels[wheel].rows[row].vertical_force;
    };
    BOOST_TEST(
      near(get_figure(vehicle.axle[0], "axle_unbalanced_acceleration_m_per_s2"), 0.8, 1e-12, "V^2/R [m/s2]"));
    BOOST_TEST(near((load(0, 0) - load(1, 0)) / 160e3 * 9.81 / 0.8 * 0.75 / scene.centre_height,
                    1,
                    0.02,
                    "the outer wheel carries h/b a/g more: ratio"));
    BOOST_TEST(near(load(0, 0) / load(1, 1), 1, 1e-9, "in a curve to the right it is the left one"));
    BOOST_TEST(near(load(0, 2), 160e3, 200, "the outer wheel carries all [N]"));
    BOOST_TEST(near(load(1, 2), 0, 0, "when the inner one is lifted [N]"));
    BOOST_TEST(
      test::same_text(vehicle.wheels[1].rows[2].doubts, lifted_by_curve(true), "and is not trusted then"));
  }
} // namespace
