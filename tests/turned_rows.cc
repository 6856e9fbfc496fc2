// label: fast

// Displacements on rows whose normal turns from one to the next (conformal contact): against plain sums of
// half-spaces' influences that are turned; rows turned alike are a plane.

#include "near.h"
#include "quadratic_distance.h"

#include <wheelrail/halfspace/turned_rows.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <vector>

using namespace wheelrail;
using test::near;
using test::near_relative;
using test::quadratic_distance;

namespace
{
  HalfspaceProblem
  unlike_bodies()
  {
    HalfspaceProblem problem;
    problem.grid  = {4, 5, 1e-3, 0.5e-3, 0, 0};
    problem.body1 = {80e9, 0.3};
    problem.body2 = {40e9, 0.2};
    return problem;
  }

  using Three = std::array<std::vector<double>, 3>;

  /// The displacements, or the slip, that come to those of a plane.
  Three
  added(const HalfspaceProblem &problem, const std::vector<double> &angles, const Three &t, const bool slip)
  {
    const TurnedRows rows(problem, angles);
    const auto       n = std::size_t(problem.grid.size());
    Three            u{{std::vector<double>(n), std::vector<double>(n), std::vector<double>(n)}};
    if (slip)
      rows.add_slip({{&t[0], &t[1], &t[2]}}, {{&u[0], &u[1], &u[2]}});
    else
      rows.add_displacement({{&t[0], &t[1], &t[2]}}, {{&u[0], &u[1], &u[2]}});
    return u;
  }

  BOOST_AUTO_TEST_CASE(test_sums)
  {
    const HalfspaceProblem    problem = unlike_bodies();
    const HalfspaceGrid      &grid    = problem.grid;
    const std::vector<double> angles{-0.5, -0.3, 0, 0.2, 0.6};
    Three                     t;
    for (std::size_t d = 0; d < 3; ++d)
      for (int e = 0; e < grid.size(); ++e)
        t[d].push_back(1e8 * std::sin(e + 2. * double(d)));
    const HalfspaceConstants constants = halfspace_constants(problem.body1, problem.body2);
    for (const bool slip : {false, true})
      {
        const Three found = added(problem, angles, t, slip);
        double      worst = 0, largest = 0;
        for (int i = 0; i < grid.size(); ++i)
          {
            double y = 0, n = 0;
            for (int j = 0; j < grid.size(); ++j)
              {
                const double x = (i % grid.mx - j % grid.mx) * grid.dx,
                             s = (i / grid.mx - j / grid.mx) * grid.dy;
                auto A         = influence_coefficients(constants, grid.dx, grid.dy, x, s);
                if (slip)
                  {
                    const auto ahead = influence_coefficients(constants, grid.dx, grid.dy, x + grid.dx, s);
                    for (std::size_t a = 0; a < 3; ++a)
                      for (std::size_t b = 0; b < 3; ++b)
                        A[a][b] = (A[a][b] - ahead[a][b]) / grid.dx;
                  }
                double w[2] = {0, 0};
                for (std::size_t b = 0; b < 3; ++b)
                  for (std::size_t a = 0; a < 2; ++a)
                    w[a] += A[a + 1][b] * t[b][std::size_t(j)];
                const double turn = angles[std::size_t(i / grid.mx)] - angles[std::size_t(j / grid.mx)];
                y += w[0] * (std::cos(turn) - 1) + w[1] * std::sin(turn);
                n += w[1] * (std::cos(turn) - 1) - w[0] * std::sin(turn);
              }
            worst = std::max(
              {worst, std::abs(found[1][std::size_t(i)] - y), std::abs(found[2][std::size_t(i)] - n)});
            largest = std::max({largest, std::abs(y), std::abs(n)});
          }
        BOOST_TEST(near(worst / largest, 0, 1e-9, slip ? "slip against sums" : "displacements against sums"));
        BOOST_TEST(near(found[0][7], 0, 0, "nothing along the rows"));
      }
    const Three plane = added(problem, std::vector<double>(5, 0.4), t, false);
    BOOST_TEST(near(plane[1][7] / 1e-6, 0, 1e-9, "rows turned alike: across"));
    BOOST_TEST(near(plane[2][7] / 1e-6, 0, 1e-9, "rows turned alike: normal"));
  }

  /// Like materials: on turned rows pressure shifts the surfaces apart, tractions lift them.
  BOOST_AUTO_TEST_CASE(test_solution)
  {
    HalfspaceProblem problem    = unlike_bodies();
    problem.body2               = problem.body1;
    problem.grid                = centred_grid(3e-3, 6e-3, 0.25e-3, 0.25e-3);
    problem.undeformed_distance = quadratic_distance(problem.grid, 0.4, 0.4);
    problem.normal_force        = 4000;
    problem.friction.at_rest    = 0.3;
    std::vector<double> angles;
    for (int j = 0; j < problem.grid.my; ++j)
      angles.push_back(problem.grid.y(j) / 10e-3);
    std::shared_ptr<HalfspaceKernels> kernels;
    const HalfspaceSolution           turned = solve_turned(problem, angles, 20, kernels),
                            plane =
                              solve_turned(problem, std::vector<double>(angles.size(), 0.), 20, kernels),
                            flat = solve_rolling(problem);
    BOOST_TEST(near_relative(plane.peak_pressure, flat.peak_pressure, 1e-6, "no turn: peak pressure"));
    BOOST_TEST((turned.converged() && turned.peak_pressure < flat.peak_pressure),
               "turned: less peak pressure");
    BOOST_TEST(near_relative(turned.fn, 4000, 1e-6, "its force"));
    // symmetric in y: the same to both sides, opposite across
    const auto at = [&](const std::vector<double> &field, const int row) {
      return field[std::size_t(problem.grid.mx / 2 + problem.grid.mx * (problem.grid.my / 2 + row))];
    };
    BOOST_TEST(
      near_relative(at(turned.pressure, 3), at(turned.pressure, -3), 1e-4, "pressures on both sides"));
    BOOST_TEST(near((at(turned.traction_y, 3) + at(turned.traction_y, -3)) / turned.peak_pressure,
                    0,
                    1e-3,
                    "tractions across are opposite"));
    BOOST_TEST(std::abs(at(turned.traction_y, 3)) > 1e-3 * turned.peak_pressure,
               "and there, without creepage");
  }
} // namespace
