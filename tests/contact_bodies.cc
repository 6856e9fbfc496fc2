// Cases of wheel and rail of CONTACT's files between true bodies: the same contact as the scene that the file
// was written from, on both sides of the track; and what they do not take.

#include "contact_inputs.h"
#include "messages.h"

#include <wheelrail/bodies/body_contact.h>
#include <wheelrail/contactfiles/case_bodies.h>
#include <wheelrail/contactfiles/inp_file.h>
#include <wheelrail/contactfiles/wheel_rail_input.h>

#include <cmath>
#include <fstream>
#include <string>
#include <vector>

using namespace wheelrail;
using test::near;
using test::near_relative;
using test::replaced;
using test::same_text;

namespace
{
  constexpr double load = 60e3;

  struct Written
  {
    Scene         scene;
    SceneGeometry geometry;
    std::string   input;
  };

  Written
  written(std::vector<std::string> sets)
  {
    sets.insert(sets.end(), {"Half-space/Element size = 0.6 mm", "Half-space/Bodies = real"});
    const Scene          scene    = test::scene_from_text("", "x.prm", sets).scene;
    const SceneGeometry  geometry = make_geometry(scene);
    const WheelRailInput files    = wheel_rail_input(scene, geometry, load, "rail.txt", "wheel.txt");
    std::ofstream("rail.txt") << files.rail;
    std::ofstream("wheel.txt") << files.wheel;
    return {scene, geometry, files.input};
  }

  /// The row of the one case of an input, and sentences.
  FigureTable
  answer(const std::string &text, std::vector<std::string> &without)
  {
    const auto cases = read_inp_text(text, "x.inp");
    return bodies_table(cases, solve_cases(cases), without);
  }

  double
  value(const FigureTable &table, const char *key)
  {
    const auto *const column = table.find(key);
    return column && !column->empty() ? column->front() : 0;
  }

  /// Driven, before the flange root.
  BOOST_AUTO_TEST_CASE(test_same_contact)
  {
    const Written given = written({"Wheelset/Lateral shift = -4 mm", "Wheelset/Traction coefficient = 0.1"});
    WheelRailLoad pressed;
    pressed.force              = load;
    pressed.vertical           = true;
    pressed.longitudinal       = 0.1 * load;
    const WheelRailSolution  s = solve_wheel_rail(given.scene, given.geometry, pressed, {});
    std::vector<std::string> without;
    const FigureTable        right = answer(given.input, without);
    BOOST_TEST((without.empty() && right.rows() == 1),
               "one row" + (without.empty() ? "" : ": " + without.front()));
    BOOST_TEST(
      near_relative(value(right, "max_pressure_Pa"), s.solution.peak_pressure, 3e-3, "peak pressure"));
    BOOST_TEST(near_relative(value(right, "area_of_whole_elements_m2"), s.solution.area, 1e-2, "area"));
    BOOST_TEST(
      near_relative(value(right, "longitudinal_force_N"), s.solution.fx, 1e-3, "longitudinal force"));
    BOOST_TEST(near(value(right, "creepage"), s.reference->creepage, 2e-5, "creepage"));
    BOOST_TEST(
      near(value(right, "contact_angle_rad"), -s.reference->angle, 1e-3, "angle, falling to the left"));
    BOOST_TEST(near(value(right, "y_track_m"), 0.75 - s.reference->place.x, 1e-4, "place, to the right"));
    BOOST_TEST(
      near(value(right, "tangential_lateral_force_N"), -s.solution.fy, 2e-3 * load, "lateral force"));
    BOOST_TEST(std::abs(value(right, "relative_difference_max_pressure")) < 0.1, "beside the half-spaces");

    // the mirror image
    const FigureTable left =
      answer(replaced(replaced(given.input, " 12031", " 02031"), "0 4 60000", "0 -4 60000"), without);
    BOOST_TEST(near_relative(
      value(left, "max_pressure_Pa"), value(right, "max_pressure_Pa"), 1e-9, "left: peak pressure"));
    for (const char *key : {"y_track_m", "contact_angle_rad", "tangential_lateral_force_N", "spin_per_m"})
      BOOST_TEST(
        near_relative(value(left, key), -value(right, key), 1e-6, std::string("left, turned: ") + key));
  }

  /// A pitch rate given, and a wheel whose origin lies on its flange back.
  BOOST_AUTO_TEST_CASE(test_rate)
  {
    const Written given = written({"Wheelset/Drive = rate", "Wheelset/Creepage = 0.002"});
    WheelRailLoad pressed;
    pressed.force             = load;
    pressed.vertical          = true;
    pressed.rate_held         = true;
    pressed.creepage          = 2e-3;
    const WheelRailSolution s = solve_wheel_rail(given.scene, given.geometry, pressed, {});
    std::ifstream           file("wheel.txt");
    std::ofstream           out("moved.txt");
    for (double y = 0, z = 0; file >> y >> z;)
      out << y + 70 << ' ' << z << '\n';
    out.close();
    std::vector<std::string> without;
    const FigureTable        row =
      answer(replaced(replaced(given.input, "wheel.txt", "moved.txt"), " 1360 -70 ", " 1360 0 "), without);
    BOOST_TEST((without.empty() && row.rows() == 1),
               "one row" + (without.empty() ? "" : ": " + without.front()));
    BOOST_TEST(
      near_relative(value(row, "max_pressure_Pa"), s.solution.peak_pressure, 3e-3, "rate: peak pressure"));
    BOOST_TEST(
      near_relative(value(row, "longitudinal_force_N"), s.solution.fx, 1e-2, "rate: longitudinal force"));
  }

  BOOST_AUTO_TEST_CASE(test_refusals)
  {
    const std::string given = written({"Wheelset/Drive = rate"}).input;
    const auto expect = [&](const std::string &from, const std::string &to, const std::string &sentence) {
      std::vector<std::string> without;
      answer(replaced(given, from, to), without);
      BOOST_TEST(same_text(without.empty() ? "" : without.front(), "x.inp:4: " + sentence, sentence));
    };
    expect(" 12031", " 12001", "true bodies do not take a motion other than steady rolling; taken is T = 3");
    std::vector<std::string> without;
    answer(test::basic.substr(0, test::basic.find("% Case 2")) + " 0 MODULE\n", without);
    BOOST_TEST(same_text(without.empty() ? "" : without.front(),
                         "x.inp:3: true bodies have an answer for wheel on rail, module 1, alone",
                         "basic contact"));
  }
} // namespace
