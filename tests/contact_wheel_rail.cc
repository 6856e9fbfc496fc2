// label: fast

// Cases of wheel and rail (module 1) of CONTACT: solved, against the rows that CONTACT prints; a left-hand
// wheel is the mirror image; a force given finds the pitch rate that gives it; printed blocks.

#include "contact_inputs.h"
#include "messages.h"
#include "reference_table.h"

#include <wheelrail/base/read_file.h>
#include <wheelrail/contactfiles/case_checks.h>
#include <wheelrail/contactfiles/contact_command.h>
#include <wheelrail/contactfiles/gap_search.h>
#include <wheelrail/contactfiles/inp_file.h>
#include <wheelrail/contactfiles/printed_blocks.h>
#include <wheelrail/contactfiles/section_line.h>
#include <wheelrail/contactfiles/solve_cases.h>
#include <wheelrail/contactfiles/surface_shapes.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <tuple>
#include <vector>

using namespace wheelrail;
using test::near;
using test::near_relative;

namespace
{
  /// A circle of radius 100 mm and a straight line, as points 0.1 mm and 1 mm apart.
  void
  make_profiles()
  {
    std::ofstream rail("round.prr"), wheel("flat.prw");
    for (std::ofstream *file : {&rail, &wheel})
      *file << "header.begin\n version = 1\n type = " << (file == &wheel) << "\nheader.end\nspline.begin\n"
            << " units.len.f = 1000.\n point.begin\n";
    char line[64];
    for (int k = -600; k <= 600; ++k)
      {
        std::snprintf(line, sizeof line, "%.6f %.6f\n", 0.1 * k, 100 - std::sqrt(1e4 - 0.01 * k * k));
        rail << line;
      }
    for (int k = 50; k >= -50; --k)
      wheel << k << " 0\n";
    rail << " point.end\nspline.end\n";
    wheel << " point.end\nspline.end\n";
  }

  void
  compare_printed(const std::vector<ContactCase> &cases,
                  const std::vector<CaseResult>  &results,
                  const std::string              &table)
  {
    for (const auto &row : test::read_table(table))
      {
        const std::size_t k    = std::stoul(row[0]) - 1;
        const std::string name = row[1] + ": ";
        BOOST_REQUIRE_MESSAGE(results.at(k).wheel_rail && results[k].wheel_rail->patches.size() == 1,
                              name + "one patch");
        const WheelRailCase     &w = *results[k].wheel_rail;
        const WheelRailPatch    &p = w.patches.front();
        const HalfspaceSolution &s = p.solution;
        BOOST_TEST(w.not_reached.empty(), name + "converged");
        std::size_t column = 2;
        // at least four digits are printed
        const auto printed = [&](const double value, const double least) {
          if (column < row.size() && !row[column].empty())
            BOOST_TEST(near(value,
                            std::stod(row[column]),
                            7e-4 * std::max(std::abs(std::stod(row[column])), least),
                            name + std::to_string(column)));
          ++column;
        };
        const double length = cases[k].digits.motion == 1 ? 1e3 : 1; // shifts in mm
        printed(1e3 * w.height, 1);
        for (const double force :
             {w.force_track[0], w.force_track[1], w.force_track[2], w.force_wheelset[0], w.force_wheelset[1]})
          printed(force, 24);
        for (const double place : {p.in_track[0], p.in_track[1], p.in_track[2]})
          printed(1e3 * place, 1);
        printed(p.angle, 0.1);
        for (const double place : {p.on_wheel[0], p.on_wheel[1], p.on_wheel[2]})
          printed(1e3 * place, 1);
        printed(length * p.creepage, 1e-4);
        printed(length * p.lateral_creepage, 1e-4);
        printed((length > 1 ? 1 : 1e-3) * p.spin, 1e-4);
        for (const double force : {s.fn, s.fx, s.fy})
          printed(force, 24);
        printed(1e3 * s.spin_moment, 100);
        printed(1e3 * s.approach, 0);
        printed(1e-6 * s.peak_pressure, 0);
        printed(s.contact_elements, 1500); // one element
        printed(s.adhesion_area / s.grid.element_area(), 1500);
      }
  }

  void
  compare_sides(const WheelRailCase &right, const WheelRailCase &left)
  {
    const WheelRailPatch &r = right.patches.at(0), &l = left.patches.at(0);
    BOOST_TEST(near_relative(left.height, right.height, 1e-6, "left: height"));
    BOOST_TEST(near_relative(l.solution.fn, r.solution.fn, 1e-6, "left: force"));
    BOOST_TEST(near_relative(l.solution.fy, -r.solution.fy, 1e-4, "left: lateral force turned"));
    BOOST_TEST(near_relative(l.angle, -r.angle, 1e-9, "left: angle turned"));
    BOOST_TEST(near_relative(l.in_track[1], -r.in_track[1], 1e-9, "left: place on the other side"));
    BOOST_TEST(near_relative(l.spin_moment, -r.spin_moment, 1e-3, "left: moment turned"));
    BOOST_TEST(
      near_relative(left.force_wheelset[1], -right.force_wheelset[1], 1e-4, "left: force on the wheelset"));
    const std::size_t mx = r.solution.grid.mx, my = r.solution.grid.my;
    const std::size_t e = mx / 2 + mx * (my / 3), f = mx / 2 + mx * (my - 1 - my / 3);
    BOOST_TEST(near_relative(l.solution.pressure[f], r.solution.pressure[e], 1e-4, "left: rows in a mirror"));
  }

  /// A wheel that stands still is pressed alone.
  void
  test_at_rest(ContactCase one)
  {
    for (double &speed : one.wheelset.velocity)
      speed = 0;
    const WheelRailCase rest    = *solve_cases({one}).front().wheel_rail;
    one.digits.motion           = 0;
    const WheelRailCase pressed = *solve_cases({one}).front().wheel_rail;
    BOOST_TEST((rest.not_reached.empty() && rest.patches.size() == 1), "at rest: solved");
    BOOST_TEST(near_relative(rest.force_track[2], pressed.force_track[2], 1e-6, "at rest: force"));
    BOOST_TEST(near(rest.patches.at(0).solution.fx, 0, 1e-9, "at rest: no force along"));
    one.digits.motion        = 3;
    one.wheelset.velocity[1] = 1; // across alone
    BOOST_TEST(test::same_text(
      solve_cases({one}).front().refused.at(0),
      "ball.inp:6: Half-space problem: friction coefficients, their decay and the step must not be "
      "negative, velocity and half velocity must be positive.",
      "it slides across without rolling"));
  }

  /// A rail on springs (F = 3) stands where they carry what the wheel presses it with, as a rail stands that
  /// is held there; the left one in a mirror.
  void
  test_springs(ContactCase one)
  {
    one.digits.forces        = 3;
    one.track.springs        = {100, 30, 150, -180}; // KYRAIL FYRAIL KZRAIL FZRAIL
    one.track.deviation_line = 1;
    const auto solved        = [](const ContactCase &asked) {
      const CaseResult result = solve_cases({asked}).front();
      BOOST_TEST((result.refused.empty() && result.wheel_rail->not_reached.empty()),
                 "a rail on springs: solved");
      return *result.wheel_rail;
    };
    const WheelRailCase loaded = solved(one);
    BOOST_TEST(near_relative(loaded.force_track[2], 237, 1e-5, "a rail on springs carries FZ"));
    BOOST_TEST(near_relative(
      1e3 * 100 * loaded.deflection[1], loaded.force_track[1] + 30, 1e-3, "KYRAIL dy = FY + FYRAIL"));
    BOOST_TEST(near(loaded.deflection[2], 0, 1e-15, "KZRAIL does not count where FZ is given"));

    one.digits.normal        = 0;
    one.wheelset.position[2] = 0.1;
    const WheelRailCase bent = solved(one);
    const Vector3       down = bent.deflection;
    BOOST_TEST(near_relative(
      1e3 * 100 * down[1], bent.force_track[1] + 30, 1e-3, "at a height: KYRAIL dy = FY + FYRAIL"));
    BOOST_TEST(
      near_relative(1e3 * 150 * down[2], bent.force_track[2] - 180, 1e-4, "KZRAIL dz = FZ + FZRAIL"));
    BOOST_TEST(near(1e3 * bent.height, 0.1, 1e-12, "and the height given"));
    ContactCase held         = one;
    held.digits.forces       = 0;
    held.track.deviation[0]  = 1e3 * down[1];
    held.track.deviation[1]  = 1e3 * down[2];
    const WheelRailCase same = solved(held);
    BOOST_TEST(near_relative(bent.force_track[2], same.force_track[2], 1e-5, "as a rail that is held there"));
    for (const std::size_t k : {0, 1, 2})
      BOOST_TEST(
        near(bent.patches.at(0).in_track[k], same.patches.at(0).in_track[k], 1e-9, "at the same place"));
    BOOST_TEST(
      near_relative(bent.patches[0].creepage, same.patches[0].creepage, 1e-5, "with the same creepage"));

    BOOST_TEST(
      (printed_blocks({one}, {{{}, {}, bent}}).find(" MASSLESS RAIL DEFLECTION\n     KY_RAIL     DY_DEFL") !=
       std::string::npos),
      "printed: the deflection");
    ContactCase left = one;
    left.digits.side = 0;
    for (double *value : {&left.track.springs[1], &left.wheelset.position[4], &left.wheelset.flexible[3]})
      *value = -*value;
    compare_sides(bent, solved(left));

    one.track.springs[2] = 0;
    BOOST_TEST(test::same_text(test::message_of([&] { check_case(one, nullptr); }),
                               "ball.inp:1: KYRAIL or KZRAIL, the stiffness of a spring, is not positive",
                               "a spring without stiffness"));
    one.track.springs.clear();
    BOOST_TEST(test::same_text(
      test::message_of([&] { check_case(one, nullptr); }),
      "ball.inp:7: no case has stated the springs of the rail, which F = 3 needs; set Z = 2 or 3 "
      "and state them",
      "no springs"));
    one.track.springs         = {100, 30, 150, 1e6};
    const WheelRailCase apart = solved(one);
    BOOST_TEST(apart.patches.empty(), "springs that pull the rail away");
    BOOST_TEST(near_relative(1e3 * 150 * apart.deflection[2], 1e6, 1e-6, "bend by what pulls"));
    for (const auto &[digit, value, said] :
         {std::tuple{&ControlDigits::motion,
                     2,
                     "F = 3 (rail on springs) with T = 2 is not computed; taken is T = 3 "
                     "(steady rolling)"},
          std::tuple{&ControlDigits::side,
                     5,
                     "F = 3 (rail on springs) on rollers or slices is not computed; taken "
                     "are rails of one section"}})
      {
        ContactCase other   = one;
        other.digits.*digit = value;
        BOOST_TEST(test::same_text(
          solve_cases({other}).front().refused.at(0), "ball.inp:6: " + std::string(said), said));
      }
  }

  /// Discs without flange in two columns, z down and up: both ends rise from the middle; a flange hangs down.
  void
  test_orientation()
  {
    const auto middle_below = [](const std::string &lines) {
      std::ofstream("some.csv") << lines;
      ContactProfile profile;
      profile.file      = "some.csv";
      const auto points = section_points(profile, true);
      return points[1].y > points[0].y && points[2].y > points[3].y;
    };
    BOOST_TEST(middle_below("-10 -1.4\n-3 0\n3 0\n10 -1.9\n"), "a disc, z down");
    BOOST_TEST(middle_below("-10 1.4\n-3 0\n3 0\n10 1.9\n"), "a disc, z up");
    const auto flange_below = [&](const std::string &lines) { return !middle_below(lines); };
    BOOST_TEST((flange_below("-60 28\n-40 5\n0 0\n40 1\n") && flange_below("-60 -28\n-40 -5\n0 0\n40 -1\n")),
               "a flange, hollow worn, z down and up");
  }

  /// The sentence on the first case of the file with something replaced.
  std::string
  refusal(const std::string &from, const std::string &to)
  {
    auto cases = read_inp_text(test::replaced(read_whole_file("ball.inp"), from, to), "x.inp");
    cases.resize(1);
    const auto refused = solve_cases(cases).front().refused;
    return refused.empty() ? "" : refused.front();
  }

  void
  test_refusals()
  {
    BOOST_TEST(test::same_text(
      refusal(" 0.2 0.2 1 90d", " 1e-7 0.2 1 90d"),
      "x.inp:6: Half-spaces: the overlap of wheel and rail is more than 1000000 elements long: "
      "a position or force out of scale",
      "elements out of scale"));
    const auto misread = [](const std::string &from, const std::string &to) {
      return test::message_of([&]() { refusal(from, to); });
    };
    BOOST_TEST(test::same_text(
      misread(" 0 0 237 0 0.004", " 0 0 1e13 0 0.004"),
      "x.inp:6: a number of the track, the wheelset or the elements is not finite, or beyond 1e12",
      "a load out of scale"));
    BOOST_TEST(test::same_text(misread(" 0.2 0.2 1 90d", " 0.2 200 1 90d"),
                               "x.inp:12: DX and DS, the size of the elements, are not from 0 to 100 mm",
                               "large elements"));
    BOOST_TEST(test::same_text(misread(" 0 0 100                FBDIST", " 0 0 0 FBDIST"),
                               "x.inp:16: NOMRADW, or NOMRADR of a roller, is not positive",
                               "a wheel without radius"));
    std::ofstream("three.prr") << "0 0\n1 0\n2 0\n";
    BOOST_TEST(test::same_text(refusal("round.prr", "three.prr"),
                               "three.prr: 3 points; a profile of an input file of CONTACT has four or more",
                               "too few points"));
    std::ofstream("half.prr") << "0 0\n10 1\n20 4\n30 9\n40 16\n";
    std::filesystem::copy_file("half.prr", "round.prr", std::filesystem::copy_options::overwrite_existing);
    BOOST_TEST(
      test::same_text(refusal(" -1 0 0 0               GAUGHT", " 14 0 1435 0 GAUGHT"),
                      "round.prr:1: the rail has no place beside its top at which a gauge could be measured",
                      "a rail without a gauge side"));
    BOOST_TEST(test::same_text(
      refusal(" -1 0 0 0               GAUGHT", " -1 0 0 0 1e-6 GAUGHT"),
      "x.inp:13: CURV other than 0 (a curved track) is not computed; taken are straight tracks",
      "a curve"));
    BOOST_TEST(test::same_text(
      refusal("'flat.prw' 0 1 0", "'flat.prw' 0 1 -1"),
      "x.inp:17: SMOOTH below 0 is not computed; taken are 0 (no smoothing) and positive weights",
      "a negative weight"));
    BOOST_TEST(test::same_text(
      refusal("'flat.prw' 0 1 0", "'flat.prw' 0 1 2 0 1\n 1 150d 30d 6d 2"),
      "x.inp:17: ISMOOTH = 1 (SMOOTH as the length of a filter) is not computed; taken is ISMOOTH = "
      "0 (a smoothing spline)",
      "a filter"));
  }

  /// A wheel that leans and has yaw comes nearest beside its axle: over a roller less far, by the radii.
  void
  test_roller_locus(ContactCase one)
  {
    one.wheelset.position[3] = 0.05;
    one.wheelset.position[4] = 0.02;
    const auto nearest       = [&](const double roller) {
      one.track.roller_radius = roller;
      const RailShape     rail(one);
      const WheelShape    wheel(one);
      const WheelRailPose pose = wheel_rail_pose(one, rail.middle());
      const auto          gaps = gap_places(pose, rail.middle(), wheel.middle(), 1e-4);
      return *std::min_element(
        gaps.begin(), gaps.end(), [](const GapPlace &a, const GapPlace &b) { return a.gap < b.gap; });
    };
    const GapPlace flat = nearest(4e7), round = nearest(400);
    BOOST_TEST(std::abs(flat.x) > 1e-4, "a wheel with yaw touches beside its axle");
    BOOST_TEST(near_relative(round.x / flat.x, 400 / (400 + 133.33333), 2e-3, "over a roller by the radii"));
  }
} // namespace


BOOST_AUTO_TEST_CASE(contact_wheel_rail)
{
  make_profiles();
  for (const char *const file : {"ball.inp", "rollers.inp"})
    std::filesystem::copy_file(std::string(WHEELRAIL_TEST_DIR) + "/contact_files/" + file,
                               file,
                               std::filesystem::copy_options::overwrite_existing);
  const std::vector<ContactCase> cases   = read_inp_file("ball.inp");
  const std::vector<CaseResult>  results = solve_cases(cases);
  for (const CaseResult &result : results)
    BOOST_REQUIRE_MESSAGE(result.wheel_rail && result.wheel_rail->patches.size() == 1, "a case is solved");
  compare_printed(cases, results, "contact_wheel_rail.csv");
  std::ostringstream out;
  run_contact_command({"ball.inp", 1}, out);
  BOOST_TEST(
    (out.str().find("\nverdict: with care: Wheel and rail are half-spaces, as in CONTACT; true bodies differ "
                    "(--bodies real).\n") != std::string::npos),
    "half-spaces between wheel and rail are not trusted");
  const std::vector<ContactCase> rollers = read_inp_file("rollers.inp");
  compare_printed(rollers, solve_cases(rollers), "contact_rollers.csv");
  test_roller_locus(rollers[0]);
  compare_sides(*results[0].wheel_rail, *results[3].wheel_rail);
  BOOST_TEST(near_relative(results[4].wheel_rail->pitch_rate, -0.996, 1e-4, "the pitch rate of a force"));
  BOOST_TEST(near(results[4].wheel_rail->force_wheelset[0], -37.82, 0.01, "the force given"));
  // at 5 degrees in the axes of the wheel's section it has no angle
  BOOST_TEST(near(results[5].wheel_rail->patches[0].friction, 0.4, 1e-3, "friction by angle"));

  const std::string printed = printed_blocks(cases, results);
  for (const char *part : {"\n WHEEL-RAIL CONTACT, LEFT WHEEL,  1 CONTACT PATCH\n",
                           " ----- DATA FOR CONTACT PATCH  1 (PREV  1) -----\n",
                           ("     XCP(TR)     YCP(TR)     ZCP(TR)    DELTCP(TR)   YCP(R)      ZCP(R)\n"
                            "       -0.0697      8.7104      0.3801      0.0872      8.7104      0.3801\n"),
                           "         240.0      -37.65      -23.54       73.24   1.624E-02  -2.679E-02\n",
                           "     SPINXO      SPINYO\n        0.1303       8.721\n"})
    BOOST_TEST((printed.find(part) != std::string::npos), std::string("printed: ") + part);
  test_at_rest(cases[0]);
  test_springs(cases[0]);
  test_orientation();
  test_refusals();
}
