// label: fast

// Cases of basic contact (module 3) of CONTACT: grids, distances and slip in closed form; Hertz.

#include "contact_inputs.h"
#include "reference_table.h"

#include <wheelrail/contactfiles/case_checks.h>
#include <wheelrail/contactfiles/case_problem.h>
#include <wheelrail/contactfiles/inp_file.h>
#include <wheelrail/contactfiles/solve_cases.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

using namespace wheelrail;
using test::basic;
using test::near;
using test::near_relative;
using test::replaced;
using test::same_text;

namespace
{
  ContactCase
  first_case(const std::string &text)
  {
    return read_inp_text(text, "x.inp").front();
  }

  /// Undeformed distance of an element of `basic` with the lines of IBASE replaced [mm].
  double
  distance(const std::string &lines, const int i, const int j)
  {
    const std::string text = replaced(
      basic, "   9    1                       IBASE, IPLAN\n   1 2 3  heights\n   4 5\n\n   6 7 8\n", lines);
    const CaseProblem    task = case_problem(first_case(replaced(text, "180.d", "0")));
    const HalfspaceGrid &grid = task.problem.grid;
    return 1e3 * task.problem.undeformed_distance[i + grid.mx * j];
  }

  BOOST_AUTO_TEST_CASE(test_distances)
  {
    // element (1, 1) of basic lies at x = -4.1 + 1.5 x 0.2 = -3.8 mm, y = -4.2 + 1.5 x 0.3 = -3.75 mm
    const double x = -3.8, y = -3.75;
    BOOST_TEST(near(distance(" 1 1\n 1 2 3 4 5 6\n", 1, 1),
                    x * x + 2 * x * y + 3 * y * y + 4 * x + 5 * y + 6,
                    1e-9,
                    "IBASE = 1"));
    BOOST_TEST(near(distance(" 2 1\n 3 1 200 -4 0.5\n 1 2 4\n", 1, 1),
                    1.5 + (x - 1) * (x - 1) / 400,
                    1e-9,
                    "IBASE = 2, between its points"));
    BOOST_TEST(near(distance(" 2 1\n 3 1 200 -3.5 0.5\n 1 2 4\n", 1, 1),
                    0.5 + (x - 1) * (x - 1) / 400,
                    1e-9,
                    "IBASE = 2, before them"));
    BOOST_TEST(near(distance(" 2 1\n 3 1 200 -5 0.5\n 1 2 4\n", 1, 1),
                    5 + (x - 1) * (x - 1) / 400,
                    1e-9,
                    "IBASE = 2, behind them"));
    BOOST_TEST(near(distance(" 3 1\n 0.1 2 3 0.2 5 6 700 800\n", 1, 1),
                    0.1 * std::sin(2 * (x - 3)) - 0.2 * std::sin(5 * (x - 6)) + x * x / 700 + y * y / 800,
                    1e-9,
                    "IBASE = 3"));
    BOOST_TEST(near(distance(" 9 1\n 1 2 3 4 5 6\n", 1, 1), 5, 1e-9, "IBASE = 9"));
    BOOST_TEST(near(distance(" 1 2\n 0 0 0 0 0 7\n 1 0 0 0 0 -14.5\n", 1, 1), 7, 1e-9, "IPLAN = 2, inside"));
    BOOST_TEST(distance(" 1 2\n 0 0 0 0 0 7\n 1 0 0 0 0 -14.4\n", 1, 1) > 100, "IPLAN = 2, outside");
    BOOST_TEST(near(distance(" 1 3\n 0 0 0 0 0 7\n 0 1 0 1 -4 -3 -4 -3\n", 1, 1),
                    7,
                    1e-9,
                    "IPLAN = 3, inside the second rectangle"));
    BOOST_TEST(distance(" 1 3\n 0 0 0 0 0 7\n 0 1 0 1 -4 -3 -3.7 -3\n", 1, 1) > 100, "IPLAN = 3, outside");
  }

  BOOST_AUTO_TEST_CASE(test_grids)
  {
    const std::string line =
      "    1                           IPOTCN\n   3    2    % mx, my\n  -4.1 -4.2  % xl, yl\n   0.2  0.3   "
      "dx, dy\n";
    for (const char *const same : {" 2\n 3 2 -4.1 -4.2 -3.5 -3.6\n",
                                   " 3\n 3 2 -4 -4.05 0.2 0.3\n",
                                   " 4\n 3 2 -4 -4.05 -3.6 -3.75\n",
                                   " 1\n 3 2 -4.1 -4.2 0.2 0.3\n"})
      {
        const HalfspaceGrid grid =
          case_problem(first_case(replaced(replaced(basic, line, same), "180.d", "0"))).problem.grid;
        BOOST_TEST((std::abs(grid.x0 + 4e-3) < 1e-12 && std::abs(grid.y0 + 4.05e-3) < 1e-12 &&
                    std::abs(grid.dx - 0.2e-3) < 1e-12 && std::abs(grid.dy - 0.3e-3) < 1e-12),
                   std::string("the grid of IPOTCN =") + std::string(same).substr(0, 2));
      }
  }

  /// Half a turn about the normal: what rolls to -x solves as what rolls to +x.
  BOOST_AUTO_TEST_CASE(test_turned)
  {
    const std::string rows =
      "   9    1                       IBASE, IPLAN\n   1 2 3  heights\n   4 5\n\n   6 7 8\n";
    std::string text = replaced(basic, rows, " 1 1\n 0.0005 0.0001 0.0008 0 0 0\n");
    text             = replaced(text,
                    "   3    2    % mx, my\n  -4.1 -4.2  % xl, yl\n   0.2  0.3   dx, dy\n",
                    " 41 27 -4.1 -4.05 0.2 0.3\n");
    text             = replaced(text, "   470.5, -0.00304, 0, 1e-4 ", "  4700. -0.0003 0.0002 1e-4 0.4 -0.7");
    const HalfspaceSolution back = solve_case(first_case(text)).solution;
    text                         = replaced(
      replaced(text, "180.d", "0"), " -0.0003 0.0002 1e-4 0.4 -0.7", " 0.0003 -0.0002 1e-4 -0.4 0.7");
    const HalfspaceSolution forward = solve_case(first_case(text)).solution;
    BOOST_TEST((back.converged() && forward.converged() && forward.fx < -1), "both directions converge");
    BOOST_TEST(near_relative(back.fx, -forward.fx, 1e-5, "longitudinal force, half a turn"));
    BOOST_TEST(near_relative(back.fy, -forward.fy, 1e-5, "lateral force, half a turn"));
    BOOST_TEST(near_relative(back.spin_moment, forward.spin_moment, 1e-5, "spin moment, half a turn"));
    const std::size_t e = 41 * 12 + 18;
    BOOST_TEST(near_relative(
      back.traction_x[e], -forward.traction_x[41 * 27 - 1 - e], 1e-3, "traction of an element, half a turn"));
  }

  BOOST_AUTO_TEST_CASE(test_extra_slip)
  {
    std::string text =
      replaced(basic, "   470.5, -0.00304, 0, 1e-4 ", "   470.5, -0.00304, 0, 1e-4 0.4 -0.7");
    text = replaced(text, "180.d", "0");
    // at element (1, 1), x = -3.8, y = -3.75 mm, and a sixth of a step of 0.2 mm ahead
    const auto slip = [&](const char extra, const std::string &lines) {
      const std::string      digits = std::string("  02202") + extra + " ";
      const HalfspaceProblem p =
        case_problem(
          first_case(replaced(replaced(text, "  022020 ", digits), "   6 7 8\n", "   6 7 8\n" + lines)))
          .problem;
      return std::vector<double>{p.xi - p.phi * p.grid.y(1) + p.rigid_slip_x[4],
                                 p.eta + p.phi * (p.grid.x(1) + p.spin_offset * p.grid.dx) +
                                   p.rigid_slip_y[4]};
    };
    const double x = -0.00304 - 1e-4 * (-3.75 + 0.7), y = 1e-4 * (-3.8 - 0.4 + 0.2 / 6);
    const auto   expect =
      [&](const std::vector<double> &found, const double wx, const double wy, const std::string &name) {
        BOOST_TEST(near(found[0], wx, 1e-12, name + ", w_x"));
        BOOST_TEST(near(found[1], wy, 1e-12, name + ", w_y"));
      };
    expect(slip('0', ""), x, y, "spin about another place");
    expect(slip('2', ""), x, 0, "E = 2");
    expect(slip('3', ""), -0.00304, y, "E = 3");
    expect(slip('9', " 1 2 3 4 5 6 7 8 9 10 11 12\n"), x + 9, y + 10, "E = 9");
  }

  /// Force given and approach given lead to each other; a force over friction with the approach given.
  BOOST_AUTO_TEST_CASE(test_approach_and_force)
  {
    const std::vector<ContactCase> cases =
      read_inp_file(std::string(WHEELRAIL_TEST_DIR) + "/contact_files/basic.inp");
    ContactCase one        = cases.at(6); // unlike spheres
    const auto  by_force   = solve_case(one).solution;
    one.digits.normal      = 0;
    one.kinematics.normal  = 1e3 * by_force.approach;
    const auto by_approach = solve_case(one).solution;
    BOOST_TEST(near_relative(by_approach.fn, by_force.fn, 1e-4, "the normal force of its approach"));
    BOOST_TEST(
      near_relative(by_approach.fx, by_force.fx, 1e-4, "the force over friction, the approach given"));
    BOOST_TEST(near_relative(by_approach.xi, by_force.xi, 1e-3, "and its creepage"));
  }

  BOOST_AUTO_TEST_CASE(test_hertz)
  {
    const double E = contact_modulus(80e9, 0.3, 80e9, 0.3);
    BOOST_TEST(near_relative(E, 80e9 / 0.7, 1e-12, "contact modulus of like bodies"));
    // a circle: p0^3 = 6 F E^2 / (pi^3 R^2), A = 1 / 2R
    const HertzContact circle = hertz_of_curvatures(1 / 0.8, 1 / 0.8, E, {true, 1e5});
    BOOST_TEST(near_relative(circle.peak_pressure,
                             std::cbrt(6 * 1e5 * E * E / (std::pow(std::acos(-1.), 3) * 0.16)),
                             1e-6,
                             "peak pressure of a circle"));
    BOOST_TEST(near_relative(circle.approach, circle.a * circle.a / 0.4, 1e-6, "its approach a^2 / R"));
    for (const double ratio : {0.2, 0.9999, 1.7, 6.})
      {
        const HertzContact a    = hertz_of_axes(ratio * 3e-3, 3e-3, E, {true, 5e4});
        const std::string  name = "an ellipse of a / b = " + std::to_string(ratio) + ": ";
        BOOST_TEST(near_relative(
          hertz_of_curvatures(a.A, a.B, E, {false, a.approach}).force, 5e4, 1e-6, name + "force"));
        BOOST_TEST(near_relative(
          hertz_of_curvatures(a.A, a.B, E, {true, 5e4}).a, ratio * 3e-3, 1e-6, name + "axis along x"));
        BOOST_TEST(
          near_relative(hertz_of_ratio(a.A, ratio, E, {true, 5e4}).b, 3e-3, 1e-6, name + "axis along y"));
        BOOST_TEST(
          near_relative(hertz_of_axes(a.a, a.b, E, {false, a.approach}).B, a.B, 1e-9, name + "curvature"));
      }
  }

  BOOST_AUTO_TEST_CASE(test_pressure_given)
  {
    std::string text = replaced(basic, "  203100 ", "  233100 ");
    text             = replaced(
      text,
      "    1                           IPOTCN\n   3    2    % mx, my\n  -4.1 -4.2  % xl, yl\n   0.2  0.3   "
                  "dx, dy\n   9    1                       IBASE, IPLAN\n   1 2 3  heights\n   4 5\n\n   6 7 8\n",
      " -3\n 61 61 4 2 1.05\n");
    const CaseSolution s = solve_case(first_case(text));
    BOOST_TEST(near_relative(s.solution.fn, 470.5, 2e-3, "force of a parabolic pressure"));
    BOOST_TEST(near_relative(
      s.solution.peak_pressure, 2e6 * 470.5 / (std::acos(-1.) * 4 * 2), 1e-9, "its peak 2 FN / (pi a b)"));
    BOOST_TEST(near_relative(s.solution.approach, s.hertz->approach, 1e-12, "approach of Hertz"));
  }

  /// Cylinders by their curvature or length: the strip of Carter's printed case, pressure given.
  BOOST_AUTO_TEST_CASE(test_strip)
  {
    ContactCase one      = read_inp_file(std::string(WHEELRAIL_TEST_DIR) + "/contact_files/basic.inp").at(0);
    one.grid.kind        = -4;
    one.grid.values      = {0.001, 100, 1.1};
    const CaseSolution s = solve_case(one);
    BOOST_TEST(near_relative(
      s.hertz->a, std::sqrt(4 * 0.5 * 178.9e3 / (M_PI * 82e9 / 0.72)), 1e-9, "half length of a strip"));
    BOOST_TEST(near_relative(s.hertz->peak_pressure, 113.9e6, 5e-4, "its peak pressure"));
    BOOST_TEST(near_relative(s.solution.peak_pressure, 113.9e6, 5e-3, "solved"));
    BOOST_TEST(near_relative(s.solution.fx, 6955, 1e-2, "its force"));
    one.grid.kind   = -5;
    one.grid.values = {1e3 * s.hertz->a, 100, 1.1};
    BOOST_TEST(near_relative(solve_case(one).hertz->A, 1, 1e-9, "half curvature of a length"));
    one.grid.my            = 9; // of which 5 lie within
    one.grid.values.back() = 2;
    BOOST_TEST(same_text(
      refusals(one).at(0),
      one.file + ":" + std::to_string(one.grid.line) +
        ": IPOTCN = -5 (a strip) with rows beside it, SCALE > 1, and B = 0 is not computed; taken are "
        "SCALE <= 1, and B = 2 and 3",
      "rows beside a strip"));
    for (const int bound : {2, 3})
      {
        one.digits.bound              = bound;
        const HalfspaceSolution given = solve_case(one).solution;
        BOOST_TEST(near_relative(given.fn, 35780, 5e-3, "force of a given pressure"));
        BOOST_TEST(near_relative(given.grid.dy, 40e-3, 1e-9, "five rows in 200 mm"));
        BOOST_TEST(near(given.width_y, 200e-3, 1e-9, "and the others do not touch"));
      }
  }

  /// A surface that is inclined across (C = 4), by places and angles; rolling to -x its rows turn, too.
  BOOST_AUTO_TEST_CASE(test_inclined_surface)
  {
    const std::string text = replaced(
      replaced(basic, "  022020 ", "  024020 "), "   .28     .27 ", " 1 3 2\n -4.2 -6d\n -3.6 6d\n .28 .27 ");
    // rows at y = -4.05 and -3.75, after half a turn the other way round
    const std::vector<double> angles = case_problem(first_case(text)).angles;
    BOOST_TEST(angles.size() == 2, "two rows");
    BOOST_TEST(near_relative(angles.at(0), -3 * M_PI / 180, 1e-9, "the inclination of one"));
    BOOST_TEST(near_relative(angles.at(1), 3 * M_PI / 180, 1e-9, "and of the other"));
    // little inclined it is a plane
    ContactCase  one     = read_inp_file(std::string(WHEELRAIL_TEST_DIR) + "/contact_files/basic.inp").at(6);
    const double plane   = solve_case(one).solution.peak_pressure;
    one.digits.influence = 4;
    one.influence        = {1, 3, {{-1, 0}, {1, 1e-9}}, "", 1};
    BOOST_TEST(near_relative(solve_case(one).solution.peak_pressure, plane, 1e-4, "a plane"));
  }

  /// Rows of friction rolling to -x and to +x; a force over FN alone.
  BOOST_AUTO_TEST_CASE(test_friction_of_rows)
  {
    ContactCase one = read_inp_file(std::string(WHEELRAIL_TEST_DIR) + "/contact_files/basic.inp").at(22);
    const HalfspaceSolution forward = solve_case(one).solution;
    one.rolling.direction           = std::acos(-1.);
    one.kinematics.x                = -one.kinematics.x;
    std::reverse(one.friction.lines.begin(), one.friction.lines.end());
    const HalfspaceSolution back = solve_case(one).solution;
    BOOST_TEST(near_relative(back.fx, -forward.fx, 1e-6, "friction of rows, half a turn"));
    one.digits.forces = 1;
    one.kinematics.x  = 0.1;
    BOOST_TEST(
      near_relative(solve_case(one).solution.fx, 0.1 * 0.4705, 1e-6, "FX over FN where friction differs"));
  }

  BOOST_AUTO_TEST_CASE(test_friction_laws)
  {
    const auto law = [](const char digit) {
      const std::string text = replaced(basic, "  022020 ", std::string("  ") + digit + "22020 ");
      return case_problem(first_case(replaced(text, "0.4013  0.4013 ", "0.2 0.1 500 0.05 900\n 0 1 %")))
        .problem.friction;
    };
    for (const double v : {0., 0.3, 2.5}) // m/s; SH1 = 0.5, SH2 = 0.9
      {
        const std::string at = " at " + std::to_string(v) + " m/s";
        BOOST_TEST(near(law('2').at(v),
                        0.2 + 0.1 * std::max(0., 1 - v) + 0.05 * std::max(0., 1 - v / 1.8),
                        1e-12,
                        "L = 2" + at));
        BOOST_TEST(
          near(law('3').at(v), 0.2 + 0.1 / (1 + v / 0.5) + 0.05 / (1 + v * v / 0.81), 1e-12, "L = 3" + at));
        BOOST_TEST(near(law('4').at(v),
                        0.2 + 0.1 * std::pow(2, -v / 0.5) + 0.05 * std::pow(2, -v / 0.9),
                        1e-12,
                        "L = 4" + at));
      }
    for (const char digit : {'2', '3', '4'})
      {
        const FrictionLaw one = law(digit);
        BOOST_TEST((one.valid() && one.depends_on_speed() && std::abs(one.largest() - 0.35) < 1e-12),
                   "the largest coefficient is that at rest");
        BOOST_TEST(near(
          one.with_rest(0.7).at(0.4), 2 * one.at(0.4), 1e-12, "the same shape from another coefficient"));
        double steepest = 0;
        for (double v = 0; v < 3; v += 1e-3)
          steepest = std::max(steepest, (one.at(v) - one.at(v + 1e-6)) / 1e-6);
        BOOST_TEST((one.steepest_fall() >= 0.999 * steepest && one.steepest_fall() < 1.25 * steepest),
                   "steepest fall");
      }
  }

  BOOST_AUTO_TEST_CASE(test_refused_values)
  {
    const auto expect = [](const std::vector<std::pair<std::string, std::string>> &changes,
                           const std::string                                      &expected) {
      std::string text = basic, found;
      for (const auto &[from, to] : changes)
        text = replaced(text, from, to);
      for (const std::string &sentence : refusals(first_case(text)))
        found += sentence;
      BOOST_TEST(same_text(found, "x.inp:" + expected, expected.substr(0, 30)));
    };
    expect({{"  022020 ", "  022320 "}, {"820d2  8.1E+04  POISS 1,2,  GG 1,2", "82000 81000\n 1 1 1"}},
           "4: M = 3 (FASTSIM) on a contact that is no ellipse is not computed; taken are IPOTCN = "
           "-3 to -1");
    expect(
      {{"  203100 ", "  202100 "},
       {"  022020 ", "  024020 "},
       {"   .28     .27 ", " 0 4 2\n -1 -0.1\n 1 0.1\n .28 .27 "}},
      "4: C = 4 (angle correction) with T = 2 is not computed; taken are T = 0 and 3x.inp:10: IF_METH = 0 "
      "with VARIANT = 4 is not computed; taken is IF_METH = 1 with VARIANT = 3 (displacements turned)");
    expect({{"180.d", "90.d "}},
           "9: CHI other than 0 and 180d (rolling across x) is not computed; taken are 0 and 180d");
    expect({{"  203100 ", "  203120 "}, {"-0.00304, 0,", "0.8 -0.7"}},
           "7: a force FX, FY of FSTAT times FN or more (sliding as a whole) is not computed; taken are "
           "smaller ones, and creepages of any size");
  }
} // namespace
