// label: fast

// Friction with memory and an elastic interface layer: traction curves of the measured shape, and laws of
// them in closed form.

#include "check.h"

#include <wheelrail/base/errors.h>
#include <wheelrail/halfspace/problem.h>

#include <boost/math/special_functions/ellint_1.hpp>
#include <boost/math/special_functions/ellint_2.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

using namespace wheelrail;
using test::check;
using test::check_near;

namespace
{
  /// Relative radius across of a Hertzian patch (1882) whose extent along over that across is `ratio` < 1.
  double
  radius_across(const double radius_along, const double ratio)
  {
    const double e = std::sqrt(1 - ratio * ratio), K = boost::math::ellint_1(e), E = boost::math::ellint_2(e);
    return radius_along * (E / (ratio * ratio) - K) / (K - E);
  }

  /// The example "tractcurv" of the program CONTACT: dry, falling friction with memory, and a layer.
  HalfspaceProblem
  traction_curve_problem(const double dx)
  {
    HalfspaceProblem problem;
    problem.body1 = problem.body2 = {82e9, 0.28};
    problem.grid                  = centred_grid(8e-3, 16e-3, dx, 2 * dx);
    problem.undeformed_distance   = quadratic_distance(problem.grid, 0.625, radius_across(0.625, 0.5));
    problem.normal_force          = 106.7e3;
    problem.velocity              = 10;
    problem.friction              = {0.33, FrictionKind::exponential, 0.14, std::log(2.) / 1.25, 1};
    problem.memory_length         = 3e-6;
    problem.layer_compliance      = 1.25e-3 / 8.2e9;
    return problem;
  }

  /// Longitudinal force over 0.33 times the normal force, at a creepage.
  double
  traction(HalfspaceProblem problem, const double creepage)
  {
    problem.xi                       = -creepage;
    const HalfspaceSolution solution = solve_rolling(problem);
    check(solution.converged() && !solution.touches_grid_edge,
          "solved at a creepage of " + std::to_string(creepage) + solution.not_reached);
    check_near(solution.length_x / solution.width_y, 0.5, 0.02, "extents of the patch");
    return solution.fx / (0.33 * solution.fn);
  }

  void
  test_contact_example()
  {
    const HalfspaceProblem problem = traction_curve_problem(0.25e-3);
    struct Point
    {
      double creepage, traction;
    };
    // CONTACT's tractcurv.ref_out
    for (const Point &point :
         {Point{0.001, 0.1825}, Point{0.01, 0.9119}, Point{0.016, 0.9445}, Point{0.25, 0.5685}})
      check_near(traction(problem, point.creepage),
                 point.traction,
                 0.005,
                 "traction at creepage " + std::to_string(point.creepage) + ", CONTACT's");
    HalfspaceProblem at_once = problem;
    at_once.memory_length    = 0;
    const double slid        = 0.14 + 0.19 * std::exp2(-2.5 / 1.25);
    check_near(
      traction(at_once, 0.25), slid / 0.33, 5e-4, "full sliding without memory: the law at V times creepage");
  }

  /// A layer much softer than the bodies makes them a row of springs: Kalker's simplified theory, Fx = 8 a2 b
  /// xi / (3 L) without slip (1973).
  void
  test_soft_layer()
  {
    HalfspaceProblem problem = traction_curve_problem(0.15e-3);
    problem.friction         = FrictionLaw{100};
    problem.memory_length    = 0;
    problem.layer_compliance = 1e-9;
    problem.xi               = -1e-4;
    const auto   solution    = solve_rolling(problem);
    const double a = 0.5 * solution.length_x, b = 0.5 * solution.width_y;
    std::printf("a %.3f mm, b %.3f mm\n", 1e3 * a, 1e3 * b);
    check_near(solution.fx * 3 * problem.layer_compliance / (8 * a * a * b * 1e-4),
               1,
               0.03,
               "force of a row of springs");
  }

  void
  test_refusals()
  {
    HalfspaceProblem problem = traction_curve_problem(0.5e-3);
    problem.motion           = HalfspaceMotion::shift;
    std::string told;
    try
      {
        solve_rolling(problem);
      }
    catch (const InputError &error)
      {
        told = error.what();
      }
    check(told == "Half-space problem: friction has a memory in steady rolling only.",
          "a memory in a shift: " + told);
  }
} // namespace

int
main()
{
  test_contact_example();
  test_soft_layer();
  test_refusals();
  return test::report();
}
