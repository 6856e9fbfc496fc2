// label: fast

// Cases of basic contact (module 3) of CONTACT, solved: against the rows and the stresses that CONTACT
// prints; sequences of cases.

#include "error_of.h"
#include "reference_table.h"

#include <wheelrail/base/errors.h>
#include <wheelrail/contactfiles/inp_file.h>
#include <wheelrail/contactfiles/solve_cases.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <tuple>
#include <vector>

using namespace wheelrail;
using test::near;
using test::near_relative;
using test::same_text;

namespace
{
  void
  test_printed_rows(const std::string &file, const std::string &table, const double tolerance = 1e-3)
  {
    const std::vector<ContactCase> cases =
      read_inp_file(std::string(WHEELRAIL_TEST_DIR) + "/contact_files/" + file);
    const std::vector<CaseResult> results = solve_cases(cases);
    for (const auto &row : test::read_table(table))
      {
        const std::size_t k    = std::stoul(row[0]) - 1;
        const std::string name = row[1] + ": ";
        BOOST_REQUIRE_MESSAGE(results.at(k).solved.has_value(), name + "all is taken");
        const HalfspaceSolution &s = results[k].solved->solution;
        BOOST_TEST(s.converged(), name + "converged");
        // four digits are printed; small forces are compared to a tenth of the normal force
        const auto printed =
          [&](const std::size_t column, const double value, const double least, const char *what) {
            if (column < row.size() && !row[column].empty())
              {
                const double number = std::stod(row[column]);
                BOOST_TEST(near(value, number, tolerance * std::max(std::abs(number), least), name + what));
              }
          };
        const double force = 0.1 * std::stod(row[2]);
        printed(2, s.fn, 0, "FN");
        printed(3, s.fx, force, "FX");
        printed(4, s.fy, force, "FY");
        printed(5, 1e3 * s.spin_moment, force, "MZ");
        printed(6, 1e3 * s.approach, 0, "approach");
        printed(7, 1e-6 * s.peak_pressure, 0, "peak pressure");
        printed(8, (cases[k].digits.motion == 1 ? 1e3 : 1) * s.xi, 0, "longitudinal creepage");
        printed(9, s.eta, 1e-4, "lateral creepage");
        printed(13, hottest(s), 0, "temperature");
        const auto count = [&](const HalfspaceSolution::State state) {
          return std::to_string(std::count(s.state.begin(), s.state.end(), state));
        };
        BOOST_TEST(same_text(std::to_string(s.contact_elements) + " " + count(HalfspaceSolution::adhesion) +
                               " " + count(HalfspaceSolution::slip),
                             row[10] + " " + row[11] + " " + row[12],
                             name + "elements in contact, adhesion, slip"));
      }
  }

  /// Stresses that CONTACT prints for its case 4 of the testbank, MPa: of body 2 and of body 1.
  void
  test_points()
  {
    const auto cases  = read_inp_file(std::string(WHEELRAIL_TEST_DIR) + "/contact_files/layers.inp");
    const auto solved = solve_cases({cases.back()}).back().solved;
    BOOST_REQUIRE_MESSAGE(solved && solved->points.size() == 1 && solved->points[0].size() == 4,
                          "four points");
    const PointStress &below = solved->points[0][2], &above = solved->points[0][3]; // x = 0.4
    BOOST_TEST(near(below.z, -1e-3, 1e-15, "z of body 2 is negative"));
    for (const auto &[value, printed, name] :
         {std::tuple{below.stress.xx, 5.495e-3, "xx"},
          std::tuple{below.stress.nn, -0.1922, "zz"},
          std::tuple{below.stress.xn, 3.746e-2, "xz"},
          std::tuple{below.mean(), -6.330e-2, "mean"},
          std::tuple{above.stress.xx, -0.7574, "xx of body 1"},
          std::tuple{above.stress.yy, -0.3660, "yy of body 1"},
          std::tuple{above.stress.xn, -0.5741, "xz of body 1"},
          std::tuple{above.stress.von_mises(), 1.133, "von Mises of body 1"},
          std::tuple{above.principal[2], -1.457, "smallest principal of body 1"}})
      BOOST_TEST(near(1e-6 * value, printed, 1e-3 * std::max(0.1, std::abs(printed)), name));
    HalfspaceGrid grid;
    grid.mx = grid.my = 3;
    grid.dx = grid.dy        = 1;
    const PointBlock centres = point_block({2, {1, 2, 3, 2, 1, 2, 2}, {}, {}, {0, 1}, 1}, grid);
    BOOST_TEST((centres.x == std::vector<double>{0, 2} && centres.y == std::vector<double>{1} &&
                centres.z == std::vector<double>{0, 1e-3}),
               "ISUBS = 2: first, step and last index");
    BOOST_TEST(same_text(test::error_of<InputError>([&]() {
                           point_block({3, {1, 1, 4, 1, 1}, {}, {}, {0}, 1}, grid);
                         }),
                         "points below the surface: the index 4 lies outside of the grid, which has 1 to 3",
                         "an index outside of the grid"));
    BOOST_TEST(near(above.principal[0] + above.principal[1] + above.principal[2],
                    3 * above.mean(),
                    1e-6 * std::abs(above.mean()),
                    "sum of the principal stresses"));
  }

  /// What P says of the state that a case goes on from; what follows a refused case.
  void
  test_past()
  {
    std::vector<ContactCase> cases =
      read_inp_file(std::string(WHEELRAIL_TEST_DIR) + "/contact_files/basic.inp");
    cases.erase(cases.begin(), cases.begin() + 10);
    cases.resize(3);
    cases[2].digits.past            = 3; // the instant of the second case again
    std::vector<CaseResult> results = solve_cases(cases);
    BOOST_TEST(near_relative(
      results[2].solved->solution.xi, results[1].solved->solution.xi, 1e-6, "P = 3: the same instant again"));
    cases[2].digits.past      = 1;
    results                   = solve_cases(cases);
    const double from_nothing = solve_case(cases[2]).solution.xi;
    BOOST_TEST(near_relative(
      results[2].solved->solution.xi, from_nothing, 1e-6, "P = 1 of like materials: no tractions before"));
    cases[0].digits.influence = 3;
    cases[1].digits.past      = 0;
    results                   = solve_cases(cases);
    BOOST_TEST((!results[0].solved && !results[1].solved), "what goes on from a refused case is refused");
    BOOST_TEST(
      same_text(results[1].refused.at(0),
                cases[1].file + ":" + std::to_string(cases[1].line) +
                  ": the case goes on from one before that is not computed; taken are cases with P = 2",
                "and says so"));
    cases[0].digits.influence            = 2;
    cases[1].rolling.step                = 0.5; // two elements
    cases[1].digits.law                  = 3;
    cases[1].friction.lines[0].constants = {0.2, 0.1, 500, 0, 900};
    BOOST_TEST(same_text(
      solve_cases(cases)[1].refused.at(0),
      cases[1].file + ":" + std::to_string(cases[1].rolling.line) +
        ": DQ > DX (steps of several elements) with L = 3 and M = 0 is not computed; taken are DQ = DX, and "
        "L = 0 with M = 0",
      "steps of several elements with friction that varies are refused"));
    cases[1].rolling.step = 0.25;
    cases[1].digits.past  = 2;
    cases[1].digits.after = 2;
    BOOST_TEST((!solve_cases(cases)[1].solved && solve_cases(cases)[1].refused.empty()),
               "R = 2: checked only");
  }
} // namespace


BOOST_AUTO_TEST_CASE(contact_case_solved)
{
  test_printed_rows("basic.inp", "contact_basic_cases.csv");
  test_printed_rows("layers.inp", "contact_layer_cases.csv");
  test_printed_rows("falling.inp", "contact_falling_cases.csv");
  test_printed_rows("heat.inp", "contact_heat_cases.csv", 3e-3);
  test_points();
  test_past();
}
