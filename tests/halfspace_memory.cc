// label: fast

// Friction with memory and an elastic interface layer: traction curves of the measured shape, and laws of
// them in closed form.

#include "near.h"
#include "quadratic_distance.h"

#include <wheelrail/halfspace/problem.h>

#include <boost/math/special_functions/ellint_1.hpp>
#include <boost/math/special_functions/ellint_2.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

using namespace wheelrail;
using test::near;
using test::quadratic_distance;

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
    BOOST_TEST((solution.converged() && !solution.touches_grid_edge),
               "solved at a creepage of " + std::to_string(creepage) + solution.not_reached);
    BOOST_TEST(near(solution.length_x / solution.width_y, 0.5, 0.02, "extents of the patch"));
    return solution.fx / (0.33 * solution.fn);
  }

  BOOST_AUTO_TEST_CASE(test_contact_example)
  {
    const HalfspaceProblem problem = traction_curve_problem(0.25e-3);
    struct Point
    {
      double creepage, traction;
    };
    // CONTACT's tractcurv.ref_out
    for (const Point &point :
         {Point{0.001, 0.1825}, Point{0.01, 0.9119}, Point{0.016, 0.9445}, Point{0.25, 0.5685}})
      BOOST_TEST(near(traction(problem, point.creepage),
                      point.traction,
                      0.005,
                      "traction at creepage " + std::to_string(point.creepage) + ", CONTACT's"));
    HalfspaceProblem at_once = problem;
    at_once.memory_length    = 0;
    const double slid        = 0.14 + 0.19 * std::exp2(-2.5 / 1.25);
    BOOST_TEST(near(traction(at_once, 0.25),
                    slid / 0.33,
                    5e-4,
                    "full sliding without memory: the law at V times creepage"));
  }

  /// A layer much softer than the bodies makes them a row of springs: Kalker's simplified theory, Fx = 8 a2 b
  /// xi / (3 L) without slip (1973).
  BOOST_AUTO_TEST_CASE(test_soft_layer)
  {
    HalfspaceProblem problem = traction_curve_problem(0.15e-3);
    problem.friction         = FrictionLaw{100};
    problem.memory_length    = 0;
    problem.layer_compliance = 1e-9;
    problem.xi               = -1e-4;
    const auto   solution    = solve_rolling(problem);
    const double a = 0.5 * solution.length_x, b = 0.5 * solution.width_y;
    std::printf("a %.3f mm, b %.3f mm\n", 1e3 * a, 1e3 * b);
    BOOST_TEST(near(solution.fx * 3 * problem.layer_compliance / (8 * a * a * b * 1e-4),
                    1,
                    0.03,
                    "force of a row of springs"));
  }

  /// Steps of rolling that slides as a whole: what has touched since the first step has forgotten as much as
  /// the law says for its way; after a passage steady rolling is reached.
  BOOST_AUTO_TEST_CASE(test_steps)
  {
    HalfspaceProblem problem       = traction_curve_problem(0.5e-3);
    problem.xi                     = -0.25;
    problem.memory_length          = 0.3e-3;
    const HalfspaceSolution steady = solve_rolling(problem);
    problem.motion                 = HalfspaceMotion::transient;
    HalfspaceSolution now          = solve_rolling(problem);
    int               leading      = problem.grid.mx * (problem.grid.my / 2 + 1) - 1;
    while (now.pressure[std::size_t(leading)] <= 0)
      --leading;
    HalfspaceSolution before;
    double            worst = 0;
    for (int step = 1; step <= 40; ++step)
      {
        BOOST_TEST(now.converged(), "step " + std::to_string(step) + now.not_reached);
        // what the first elements had ahead of them a step before, and have forgotten on their way since
        for (int e = leading; e > leading - 4; --e)
          {
            const double slip = std::hypot(now.slip_x[std::size_t(e)], now.slip_y[std::size_t(e)]);
            const double law  = 0.14 + 0.19 * std::exp2(-10 * slip / 1.25),
                         ahead =
                           step == 1 || e == leading ? 0.33 : problem.previous->friction[std::size_t(e) + 1];
            worst =
              std::max(worst,
                       std::abs(now.friction[std::size_t(e)] - law -
                                (ahead - law) * std::exp(-slip * problem.grid.dx / problem.memory_length)));
          }
        before           = now;
        problem.previous = &before;
        now              = solve_rolling(problem);
      }
    BOOST_TEST(near(worst, 0, 2e-4, "coefficients of the first elements, of each step"));
    BOOST_TEST(near(now.fx / steady.fx, 1, 5e-4, "steps that lead to steady rolling"));
    worst = 0;
    for (std::size_t e = 0; e < now.friction.size(); ++e)
      if (now.pressure[e] > 0)
        worst = std::max(worst, std::abs(now.friction[e] - steady.friction[e]));
    BOOST_TEST(near(worst, 0, 5e-4, "their coefficients"));
    // a shift leaves particles where they are; 2 m/s
    problem.motion                 = HalfspaceMotion::shift;
    problem.velocity               = 1e4;
    problem.xi                     = -0.2e-3;
    problem.previous               = nullptr;
    const HalfspaceSolution first  = solve_rolling(problem);
    problem.previous               = &first;
    const HalfspaceSolution second = solve_rolling(problem);
    BOOST_TEST(
      (second.friction[std::size_t(leading)] < first.friction[std::size_t(leading)] && second.fx < first.fx),
      "a second shift forgets more");
  }
} // namespace
