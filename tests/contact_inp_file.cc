// label: fast

// Input files of CONTACT: the values of small files for both modules, those that later cases keep, damaged
// numbers and decimal commas, and the refusal of what is not computed.

#include "contact_inputs.h"
#include "messages.h"

#include <wheelrail/contactfiles/case_checks.h>
#include <wheelrail/contactfiles/inp_file.h>
#include <wheelrail/contactfiles/inp_words.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

using namespace wheelrail;
using test::basic;
using test::near;
using test::replaced;
using test::same_text;
using test::wheel_rail;

namespace
{
  const double degree = std::acos(-1.) / 180;

  void
  test_numbers()
  {
    const auto value = [](const std::string &word) { return fortran_number(word).value_or(NAN); };
    BOOST_TEST((value(".1-07") == 0.1e-7 && value("1d-5") == 1e-5 && value("2e7") == 2e7 &&
                value("1000.") == 1000 && value("+.5E+02") == 50 && value("-1.+2") == -100),
               "numbers as Fortran writes them");
    for (const char *const word :
         {"FN", "1.2.3", "-1.1-1.1", "inf", "nan", "+-5", "e5", "1e", ".", "", "0x10", "90d"})
      BOOST_TEST(!fortran_number(word), std::string("no number: \"") + word + "\"");
    const auto angle = [](const std::string &word) { return contact_angle(word).value_or(NAN); };
    BOOST_TEST(near(angle("90d"), 90 * degree, 1e-15, "90d"));
    BOOST_TEST(near(angle("180.D"), 180 * degree, 1e-15, "180.D"));
    BOOST_TEST(
      (angle("-0.0997r") == -0.0997 && angle("90d0") == 90 && angle("0.02") == 0.02 && !contact_angle("d")),
      "angles in radians, and 90d0");
  }

  void
  test_basic(const std::string &text, const std::string &name)
  {
    const std::vector<ContactCase> cases = read_inp_text(text, "x.inp");
    BOOST_REQUIRE_MESSAGE(cases.size() == 3, name + ": three cases");
    const ContactCase &a = cases[0], &b = cases[1], &c = cases[2];
    BOOST_TEST((a.number == 1 && c.number == 3 && a.line == 3 && a.word_lines[2] == 5 && c.line == 28),
               name + ": lines");
    BOOST_TEST((a.digits.past == 2 && a.digits.motion == 3 && a.digits.normal == 1 && a.digits.forces == 0 &&
                a.digits.after == 1 && a.digits.print == 3 && a.digits.trace == 4),
               name + ": digits");
    BOOST_TEST((a.iteration.maxin == 100 && a.iteration.eps == 1e-8 && a.iteration.line == 6),
               name + ": iteration");
    BOOST_TEST((a.kinematics.normal == 470.5 && a.kinematics.x == -0.00304 && a.kinematics.spin == 1e-4),
               name + ": forces and creepages between commas");
    BOOST_TEST(near(a.rolling.direction, 180 * degree, 1e-15, name + ": direction in degrees"));
    BOOST_TEST(
      (a.material.poisson[1] == 0.27 && a.material.shear[0] == 82000 && a.material.shear[1] == 81000),
      name + ": materials");
    BOOST_TEST((a.grid.kind == 1 && a.grid.mx == 3 && a.grid.my == 2 &&
                a.grid.values == std::vector<double>{-4.1, -4.2, 0.2, 0.3}),
               name + ": a grid over three lines");
    BOOST_TEST((a.distance.base == 9 && a.distance.values == std::vector<double>{1, 2, 3, 4, 5, 6}),
               name + ": distances over lines, the rest of the last one left out");
    BOOST_TEST((b.written.influence == 0 && b.digits.influence == 2 && b.written.solver == 1 &&
                b.digits.solver == 0 && b.iteration.eps == 1e-8 && b.rolling.line == 9 && b.grid.mx == 3 &&
                b.distance.values.size() == 6),
               name + ": what the second case keeps");
    BOOST_TEST((b.kinematics.normal == 500 && b.kinematics.x == 0.5 && b.kinematics.y == -0.25 &&
                b.digits.forces == 2 &&
                b.friction.lines[0].constants == std::vector<double>{0.18, 0.12, 1250, 0.03, 1000} &&
                b.friction.memory_length == 0.001 && b.digits.law == 4),
               name + ": what it states");
    BOOST_TEST((c.written.law == 1 && c.digits.law == 4), name + ": the friction law kept");
    BOOST_TEST((c.digits.damping == 2 && c.digits.gap_weights == 1 && c.material.damping.size() == 4),
               name + ": damping");
    BOOST_TEST((c.grid.kind == -3 && c.grid.values == std::vector<double>{4, 2, 1.1} &&
                c.rolling.middle == 0.25 && c.kinematics.spin_x == 0.5 && c.kinematics.spin_y == 1.5),
               name + ": the third case follows without MODULE");
    BOOST_TEST((b.kinematics.spin_x == 0 && a.rolling.middle == 1. / 6),
               name + ": defaults of optional values");
  }

  void
  test_wheel_rail()
  {
    test::make_profiles();
    const std::vector<ContactCase> cases = read_inp_text(wheel_rail, "x.inp");
    BOOST_REQUIRE_MESSAGE(cases.size() == 2, "wheel and rail: two cases");
    const ContactCase &a = cases[0], &b = cases[1];
    BOOST_TEST((a.element == 7 && a.module == 1 && a.digits.side == 1 && a.digits.forces == 1 &&
                a.digits.variation == 1),
               "element, digits");
    BOOST_TEST((a.friction.lines.size() == 2 && a.friction.lines[1].place == -0.1 &&
                a.friction.lines[1].constants[0] == 0.3),
               "friction by inclination");
    BOOST_TEST(near(a.friction.lines[0].place, -20 * degree, 1e-15, "its first angle"));
    BOOST_TEST((a.iteration.largest == 40000 && a.elements.ds == 0.3 && a.elements.d_turn == 9 &&
                a.elements.missed_gap == -1),
               "elements");
    BOOST_TEST((a.track.gauge == 1435 && a.track.cant == 0.025 && a.track.deviation[1] == 0.5 &&
                a.track.curvature == 0),
               "track");
    BOOST_TEST(same_text(a.track.profile.file, "contact_inp_file/rail of 54.prr", "the rail's file"));
    BOOST_TEST(
      (a.track.profile.options == 1 && a.track.profile.kink_width == 2 && a.wheelset.profile.options == 0),
      "profile options");
    BOOST_TEST(
      (a.wheelset.flange_place == -70 && a.wheelset.position[2] == 10000 && a.wheelset.velocity[5] == -500),
      "wheelset");
    BOOST_TEST(near(a.wheelset.position[3], -1.5 * degree, 1e-15, "roll in degrees"));
    BOOST_TEST((b.track.profile.file == a.track.profile.file && b.wheelset.radius == 460 &&
                b.wheelset.position[1] == 1 && b.wheelset.velocity[5] == -4.34 && b.digits.grid == 2 &&
                b.friction.lines.size() == 2),
               "what the second case keeps and states");
    const std::string rolling = replaced(
      replaced(wheel_rail, " 1203110", " 5203110"), " 14.0     0    1435.0   0.025", " -1 750 2 300 1e-3");
    const ContactCase roller = read_inp_text(rolling, "x.inp")[0];
    BOOST_TEST((roller.track.roller_radius == 300 && roller.track.cant == 0 && roller.track.rail_y == 750 &&
                roller.track.curvature == 1e-3),
               "a roller, placed by its origin");
  }

  void
  test_points()
  {
    std::string text = replaced(basic, "  203100 ", "  203103 ");
    text =
      replaced(text, "   6 7 8\n", "   6 7 8\n 2 4\n 1\n 3 0.5 0.25\n 9\n 2 1 1\n 0.0 0.4\n 0.1\n -1\n 0\n");
    const ContactCase one = read_inp_text(text, "x.inp")[0];
    BOOST_TEST((one.points_file == 2 && one.points_output == 4 && one.points.size() == 2 &&
                one.points[0].z == std::vector<double>{0.5, 0.75, 1} &&
                one.points[1].x == std::vector<double>{0, 0.4} && one.points[1].z == std::vector<double>{-1}),
               "points below the surface");
  }

  /// What is said of an input, or that nothing is.
  std::string
  message_of(const std::string &text)
  {
    return test::message_of([&]() { read_inp_text(text, "x.inp"); });
  }

  /// Inputs, and the line and message of the fault of each.
  void
  check_faults(const std::vector<std::pair<std::string, std::string>> &faults)
  {
    for (const auto &[text, expected] : faults)
      BOOST_TEST(same_text(message_of(text), "x.inp:" + expected, expected));
  }

  /// The line of a damaged number is told, though values may go on in the next lines with values.
  void
  test_damaged_numbers()
  {
    const std::string apart = replaced(basic, "   0.4013  0.4013", "% a\n% b\n\n   0.4013  0.4013");
    check_faults({
      {replaced(apart, ".28     .27 ", ".28     .2o7"),
       "13: \".2o7\" stands where POISS2 should; a number is needed"},
      {replaced(apart, "0.4013               FSTAT, FKIN\n", "O.4013  FSTAT, FKIN\n% c\n% d\n% e\n"),
       "11: FKIN is missing: \"O.4013\" stands in its place, and \"180.d\" begins line 15, where it could "
       "follow"},
      {replaced(basic, "   1 2 3  heights", "   1 2.5mm 3"),
       "16: \"2.5mm\" stands where the undeformed distance of IBASE = 9, value 2 of 6 should; a number is "
       "needed"},
    });
  }

  /// CONTACT separates numbers by commas. What can only be meant as decimal commas is refused.
  void
  test_decimal_commas()
  {
    const std::string advice = " need; write a decimal point, or a blank behind a comma between two numbers";
    check_faults({
      {replaced(basic, "0.4013  0.4013", "0,4013  0,4013"),
       "8: \"0,4013\" reads as two numbers, 0 and 4013, and the line has more numbers than FSTAT FKIN" +
         advice},
      {replaced(basic, "   470.5, -0.00304, 0, 1e-4", "   470,5 -0.00304 0 1e-4"),
       "7: \"470,5\" reads as two numbers, 470 and 5, and the line has more numbers than FN CKSI CETA CPHI "
       "{SPINXO} {SPINYO}" +
         advice},
      {replaced(basic, "180.d   0.2  ", "180.d   0,2  "),
       "9: \"0,2\" reads as two numbers, 0 and 2, and the line has more numbers than CHI DQ VELOC "
       "{FACPHI}" +
         advice},
      {replaced(basic, "-4.1 -4.2  % xl, yl\n   0.2  0.3", "-4,1 -4.2  % xl, yl\n   0.2  0.3"),
       "13: \"-4,1\" reads as two numbers, -4 and 1, and the line has more numbers than MX MY XL YL DX DY" +
         advice},
      {replaced(basic, "   4 5\n", "   4,5 5 6\n"),
       "17: \"4,5\" reads as two numbers, 4 and 5, and the line has more numbers than the undeformed "
       "distance of IBASE = 9" +
         advice},
    });
    for (const auto &[from, to] : std::vector<std::pair<std::string, std::string>>{
           {"   3    2    % mx", "   3,2  % mx"},
           {"-4.1 -4.2", "-4,-5"},
           {"   470.5, -0.00304, 0, 1e-4", "470,0,0,1e-4,0,1"},
           {"   1 2 3  heights\n   4 5\n\n   6 7 8", "1,2\n3,4\n5,6"},
           {"0.4013  0.4013", "0.4013,0.4013,0.5"},
           {"0.4013  0.4013", "1, 1 2"}})
      BOOST_TEST(
        same_text(message_of(replaced(basic, from, to)), "no message", "commas that CONTACT reads: " + to));
  }

  void
  test_refusals()
  {
    const std::vector<ContactCase> cases = read_inp_text(basic, "x.inp");
    BOOST_TEST(refusals(cases[0]).empty(), "steady rolling is taken");
    std::string found;
    for (const std::string &sentence :
         refusals(read_inp_text(replaced(basic, "  022020 ", "  023020 "), "x.inp")[0]))
      found += sentence;
    BOOST_TEST(
      same_text(found,
                "x.inp:4: C = 3 (influence functions: half-space, bilinear) is not computed; taken are 0 (as "
                "before), 1 "
                "(as before), 2 (half-space) or 4 (half-space with angle correction)",
                "an influence function is refused"));
    BOOST_TEST(refusals(cases[2]).size() == 2, "so are damping and gap weights");
    const ContactCase more =
      read_inp_text(replaced(basic, "0.4013  0.4013 ", "0.4013 0.4013 0.5 "), "x.inp")[0];
    BOOST_TEST(same_text(more.notes.at(0),
                         "x.inp:8: the numbers from 0.5 on are not read; FSTAT FKIN stand before them",
                         "a number too many"));
  }

} // namespace


BOOST_AUTO_TEST_CASE(contact_inp_file)
{
  test_numbers();
  test_basic(basic, "LF");
  std::string other;
  for (const char c : basic)
    other += c == '\n' ? std::string("\r\n") : c == ' ' && other.size() % 2 == 0 ? "\t" : std::string(1, c);
  test_basic(other, "CR LF and tabs");
  test_wheel_rail();
  test_points();
  test_damaged_numbers();
  test_decimal_commas();
  test_refusals();
}
