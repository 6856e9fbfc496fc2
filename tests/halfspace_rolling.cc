// Steady rolling of the half-space solver against CONTACT at equal grid and step: forces or creepages given,
// Kalker's coefficients, element tables; Carter's line contact in closed form; transient rolling that becomes
// steady.

#include "element_table.h"
#include "quadratic_distance.h"

#include <wheelrail/halfspace/problem.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

using namespace wheelrail;
using test::near;
using test::near_relative;
using test::quadratic_distance;

namespace
{
  /// 100 kN, relative radii 460 and 300 mm, steel.
  HalfspaceProblem
  ellipse(const double dx)
  {
    HalfspaceProblem problem;
    problem.grid                = centred_grid(7.7e-3, 5.9e-3, dx, dx);
    problem.undeformed_distance = quadratic_distance(problem.grid, 0.46, 0.3);
    problem.normal_force        = 100e3;
    return problem;
  }

  BOOST_AUTO_TEST_CASE(test_contact_table)
  {
    for (const auto &row : test::read_table("contact_rolling_hertz.csv"))
      {
        const auto number = [&](const int column) { return std::stod(row[column]); };
        // One row at 0.125 mm is enough here; test_kalker solves the others without slip.
        if (number(1) < 0.2 && row[0] != "F1 Fx=0.5")
          continue;
        HalfspaceProblem problem = ellipse(number(1) * 1e-3);
        const bool       fx = row[3] != "creepage", fy = row[3] == "Fx and Fy";
        problem.friction.at_rest         = number(2);
        problem.longitudinal_force_given = fx;
        problem.lateral_force_given      = fy;
        problem.fx                       = fx ? number(7) : 0;
        problem.xi                       = fx ? 0 : number(4);
        problem.eta                      = fy ? 0 : number(5);
        problem.phi                      = number(6) * 1e3;
        const auto        s              = solve_rolling(problem);
        const std::string name           = row[0] + " at " + row[1] + " mm: ";
        BOOST_TEST((s.converged() && s.newton_steps <= 15),
                   name + "converged in " + std::to_string(s.newton_steps) + " steps");
        BOOST_TEST(
          near(s.xi, number(4), std::max(1e-8, 6e-4 * std::abs(number(4))), name + "longitudinal creepage"));
        BOOST_TEST(
          near(s.eta, number(5), std::max(1e-8, 6e-4 * std::abs(number(5))), name + "lateral creepage"));
        const double small = 2e-4 * std::hypot(number(7), number(8));
        BOOST_TEST(near(s.fx, number(7), small, name + "Fx"));
        BOOST_TEST(near(s.fy, number(8), small, name + "Fy"));
        BOOST_TEST(
          near(s.spin_moment * 1e3, number(9), 2e-4 * std::abs(number(9)) + small, name + "Mz [N mm]"));
        BOOST_TEST(near_relative(s.peak_shear, number(13) * 1e6, 2e-4, name + "peak shear"));
        BOOST_TEST(near(s.slip_area * 1e6, number(18), 1., name + "slip area [mm2]"));
        BOOST_TEST((s.contact_elements == std::stoi(row[20])), name + "contact elements");
      }
  }

  /// Kalker's coefficients from no-slip solutions; they near his table (a/b = 1.329, nu 0.3: C11 4.62,
  /// C22 4.16, C23 1.89 by interpolation) with the grid.
  BOOST_AUTO_TEST_CASE(test_kalker)
  {
    double old = 1;
    for (const auto &row : test::read_table("contact_kalker_coefficients.csv"))
      {
        const auto       number  = [&](const int column) { return std::stod(row[column]); };
        HalfspaceProblem problem = ellipse(number(0) * 1e-3);
        problem.friction.at_rest = 1000;
        const double G = 210e9 / 2.6, c = std::sqrt(7.161676e-3 * 5.387172e-3);
        problem.xi             = 1e-4;
        const double c11       = -solve_rolling(problem).fx / (G * c * c * 1e-4);
        problem.xi             = 0;
        problem.eta            = 1e-4;
        const auto   lateral   = solve_rolling(problem);
        const double c22       = -lateral.fy / (G * c * c * 1e-4),
                     c32       = lateral.spin_moment / (G * c * c * c * 1e-4);
        problem.eta            = 0;
        problem.phi            = 1e-2;
        const auto   spin      = solve_rolling(problem);
        const double c23       = -spin.fy / (G * c * c * c * 1e-2),
                     c33       = -spin.spin_moment / (G * std::pow(c, 4) * 1e-2);
        const double values[5] = {c11, c22, c23, c32, c33};
        const char  *names[5]  = {"C11", "C22", "C23", "C32", "C33"};
        for (int k = 0; k < 5; ++k)
          BOOST_TEST(near_relative(
            values[k], number(2 + k), 5e-4, std::string(names[k]) + " at " + row[0] + " mm, CONTACT"));
        const double error = std::abs(c11 / 4.62 - 1);
        BOOST_TEST(error < old, "C11 nears Kalker's table, error " + std::to_string(error));
        old = error;
      }
    BOOST_TEST(old < 0.01, "C11 within 1 % of Kalker's table at 0.125 mm");
  }

  /// In steady rolling friction takes all the work of the creepages: what the elements' own slip takes tends
  /// to it as their length falls.
  BOOST_AUTO_TEST_CASE(test_work)
  {
    double missing_before = 0;
    for (const double length : {1e-3, 0.5e-3, 0.25e-3})
      {
        HalfspaceProblem problem         = ellipse(length);
        problem.longitudinal_force_given = true;
        problem.fx                       = 25e3;
        problem.phi                      = 0.1;
        const auto s                     = solve_rolling(problem);
        double     taken                 = 0;
        for (std::size_t e = 0; e < s.slip_x.size(); ++e)
          taken -= (s.traction_x[e] * s.slip_x[e] + s.traction_y[e] * s.slip_y[e]) * s.grid.element_area();
        BOOST_TEST(near(s.creepage_work,
                        -s.fx * s.xi - s.fy * s.eta - s.spin_moment * s.phi,
                        1e-9 * s.creepage_work,
                        "work of force, moment and creepages [J/m]"));
        // spin is counted a sixth of an element upstream of the centres, the mean of tractions half of one
        BOOST_TEST(near((s.friction_work - s.fy * s.phi * s.grid.dx / 3) / s.creepage_work,
                        1,
                        1e-3,
                        "friction, with tractions of both ends of a way"));
        const double missing = 1 - taken / s.creepage_work;
        BOOST_TEST(missing > 0,
                   "elements of " + std::to_string(1e3 * length) + " mm miss " + std::to_string(missing));
        if (missing_before > 0)
          BOOST_TEST(missing < 0.65 * missing_before, "  which falls with their length");
        missing_before = missing;
      }
    BOOST_TEST(missing_before < 0.1, "friction takes what the creepages give");
  }

  /// The element table of one rolling contact.
  BOOST_AUTO_TEST_CASE(test_field)
  {
    HalfspaceProblem problem         = ellipse(0.25e-3);
    problem.longitudinal_force_given = true;
    problem.fx                       = 25e3;
    const auto   s                   = solve_rolling(problem);
    const auto   table               = test::read_table("contact_field_hertz.csv");
    const double slip                = test::check_element_table(s, table, 1e-3, 4);
    BOOST_TEST(slip < 5e-3, "slip of the element table, largest over peak " + std::to_string(slip));
    BOOST_TEST((table.size() == std::size_t(s.contact_elements)), "contact elements of the table");
  }

  /// Line contact (Carter 1926): xi = -mu (a - a') / R, F / (mu N) = 1 - (a' / a)^2, at the grids of the
  /// table.
  BOOST_AUTO_TEST_CASE(test_carter)
  {
    const double E = 210e9 / (2 * 0.91), R = 0.46, a = 5e-3, length = 2;
    double       old = 1;
    for (const auto &row : test::read_table("contact_carter2d.csv"))
      {
        const auto       number = [&](const int column) { return std::stod(row[column]); };
        HalfspaceProblem problem;
        const int        nx = std::stoi(row[0]);
        const double     dx = number(1) * 1e-3;
        problem.grid        = {nx + 10, 1, dx, length, -(nx + 9) * dx / 2, 0};
        problem.undeformed_distance =
          quadratic_distance(problem.grid, R, std::numeric_limits<double>::infinity());
        problem.normal_force             = M_PI * E * a * a / (4 * R) * length;
        problem.longitudinal_force_given = true;
        problem.fx                       = number(2) * 0.5 * problem.normal_force;
        const auto        s              = solve_rolling(problem);
        const std::string name           = "Carter, " + row[0] + " elements, F/(mu N) = " + row[2] + ": ";
        BOOST_TEST(near_relative(s.xi, number(3), 2e-3, name + "creepage, CONTACT"));
        BOOST_TEST(near_relative(s.peak_shear, number(10) * 1e6, 2e-3, name + "peak shear, CONTACT"));
        const double adhesion = a * std::sqrt(1 - number(2)), xi = -0.5 * (a - adhesion) / R;
        if (dx < 0.06e-3)
          BOOST_TEST(near_relative(s.xi, xi, 0.005, name + "creepage, closed form"));
        BOOST_TEST(
          near(s.adhesion_area / length / 2, adhesion, 2 * dx, name + "half-width of adhesion, closed form"));
        if (number(2) == 0.9)
          {
            BOOST_TEST(std::abs(s.xi / xi - 1) < 0.6 * old, name + "creepage nears the closed form");
            old = std::abs(s.xi / xi - 1);
          }
      }
  }

  /// Rolling from rest: step by step the tractions become those of steady rolling.
  BOOST_AUTO_TEST_CASE(test_transient)
  {
    HalfspaceProblem steady     = ellipse(0.5e-3);
    steady.xi                   = 1e-3;
    steady.eta                  = -5e-4;
    steady.phi                  = 0.1;
    steady.tangential_tolerance = 1e-7;
    const auto       end        = solve_rolling(steady);
    HalfspaceProblem step       = steady;
    step.motion                 = HalfspaceMotion::transient;
    HalfspaceSolution now       = solve_rolling(step);
    const double      first     = now.fx;
    for (int k = 0; k < 120; ++k)
      {
        const HalfspaceSolution old = now;
        step.previous               = &old;
        now                         = solve_rolling(step);
        if (!now.converged())
          BOOST_TEST(false, "transient step " + std::to_string(k) + " converged");
      }
    double error = 0;
    for (int e = 0; e < end.grid.size(); ++e)
      error = std::max(
        error, std::hypot(now.traction_x[e] - end.traction_x[e], now.traction_y[e] - end.traction_y[e]));
    BOOST_TEST(std::abs(first) < 0.2 * std::abs(end.fx), "the first step builds up little force");
    BOOST_TEST(error < 3e-3 * end.peak_shear,
               "tractions after 60 mm of rolling are steady, largest difference over peak " +
                 std::to_string(error / end.peak_shear));
    BOOST_TEST(near_relative(now.fx, end.fx, 1e-3, "longitudinal force after 60 mm of rolling"));
  }

  /// The fall-back alone (no plain Newton steps allowed) finds the same solution.
  BOOST_AUTO_TEST_CASE(test_fallback)
  {
    HalfspaceProblem problem         = ellipse(0.5e-3);
    problem.longitudinal_force_given = true;
    problem.lateral_force_given      = true;
    problem.fx                       = 30e3;
    problem.fy                       = -20e3;
    problem.phi                      = 0.3;
    const auto plain                 = solve_rolling(problem);
    problem.max_newton_steps         = 0;
    const auto slow                  = solve_rolling(problem);
    BOOST_TEST((slow.converged() && slow.newton_steps > plain.newton_steps),
               "fall-back converged in " + std::to_string(slow.newton_steps) + " steps instead of " +
                 std::to_string(plain.newton_steps));
    BOOST_TEST(near_relative(slow.xi, plain.xi, 1e-4, "longitudinal creepage of the fall-back"));
    BOOST_TEST(near_relative(slow.eta, plain.eta, 1e-4, "lateral creepage of the fall-back"));
    BOOST_TEST(near_relative(slow.peak_shear, plain.peak_shear, 1e-4, "peak shear of the fall-back"));
  }

  /// A field of rigid slip does what the creepages do; a force beyond friction is refused.
  BOOST_AUTO_TEST_CASE(test_input)
  {
    HalfspaceProblem a = ellipse(0.5e-3), b = a;
    a.xi           = 1e-3;
    a.phi          = 0.1;
    a.spin_offset  = 0;
    b.rigid_slip_x = sampled_distance(b.grid, [](double, double y) { return 1e-3 - 0.1 * y; });
    b.rigid_slip_y = sampled_distance(b.grid, [](double x, double) { return 0.1 * x; });
    const auto sa = solve_rolling(a), sb = solve_rolling(b);
    BOOST_TEST(near_relative(sb.fx, sa.fx, 1e-9, "Fx of a field of rigid slip"));
    BOOST_TEST(near_relative(sb.spin_moment, sa.spin_moment, 1e-9, "spin moment of a field of rigid slip"));
    a.longitudinal_force_given = true;
    a.fx                       = 50e3;
    const auto beyond          = solve_rolling(a);
    BOOST_TEST(
      (!beyond.within_friction && beyond.not_reached.find("Friction does not carry") != std::string::npos),
      "a force beyond friction is told");
  }

  /// Free rolling of an aluminium roller (body 1) on steel with next to no friction: elements slide along the
  /// creepage to either side, and only one sticks. Creepage of CONTACT (bentall.inp, case 2).
  BOOST_AUTO_TEST_CASE(test_free_rolling_of_unlike_bodies)
  {
    HalfspaceProblem problem;
    problem.grid = {216, 1, 1e-6, 1, -107.5e-6, 0};
    problem.undeformed_distance =
      quadratic_distance(problem.grid, 25e-3, std::numeric_limits<double>::infinity());
    problem.body1                    = {23e9, 0.31};
    problem.body2                    = {82e9, 0.28};
    problem.normal_force             = 16201.9;
    problem.friction.at_rest         = 1e-4;
    problem.longitudinal_force_given = true;
    problem.max_coupling_rounds      = 1;
    const HalfspaceSolution s        = solve_rolling(problem);
    BOOST_TEST(s.tangential_converged, "free rolling of unlike bodies converges");
    BOOST_TEST(near(s.xi, -5.260e-4, 5e-7, "its creepage"));
    BOOST_TEST(near(s.fx, 0, 1e-4, "its force"));
  }
} // namespace
