// label: fast

// Normal problem of the half-space solver: Hertz in closed form, CONTACT at the same grids, complementarity
// on a rough surface.

#include "error_of.h"
#include "quadratic_distance.h"
#include "reference_table.h"

#include <wheelrail/base/errors.h>
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
  HalfspaceProblem
  normal_problem(const HalfspaceGrid &grid, const double rx, const double ry, const double force)
  {
    HalfspaceProblem problem;
    problem.grid                = grid;
    problem.undeformed_distance = quadratic_distance(grid, rx, ry);
    problem.normal_force        = force;
    problem.motion              = HalfspaceMotion::none;
    return problem;
  }
  /// The rows of CONTACT's normal problems, each at its own grid.
  BOOST_AUTO_TEST_CASE(test_contact_table)
  {
    for (const auto &row : test::read_table("contact_hertz_normal.csv"))
      {
        const auto          number = [&](const int column) { return std::stod(row[column]); };
        const double        dx     = number(4) * 1e-3;
        const HalfspaceGrid grid   = centred_grid(1.15 * number(9) * 1e-3, 1.15 * number(10) * 1e-3, dx, dx);
        const auto s = solve_rolling(normal_problem(grid, number(2) * 1e-3, number(3) * 1e-3, number(1)));
        const std::string name = row[0] + " at " + row[4] + " mm: ";
        BOOST_TEST((s.converged() && s.not_reached.empty() && !s.touches_grid_edge),
                   name + "converged inside the grid");
        BOOST_TEST(near_relative(s.peak_pressure, number(14) * 1e6, 2e-5, name + "peak pressure, CONTACT"));
        BOOST_TEST(near(s.approach * 1e3, number(15), 5.1e-6, name + "approach in mm, CONTACT's last digit"));
        BOOST_TEST((s.contact_elements == std::stoi(row[8])), name + "contact elements, CONTACT");
        BOOST_TEST(near_relative(s.peak_pressure, number(11) * 1e6, 0.005, name + "peak pressure, Hertz"));
        BOOST_TEST(near_relative(s.approach, number(12) * 1e-3, 0.005, name + "approach, Hertz"));
        if (dx < 0.2e-3)
          BOOST_TEST(near_relative(s.area, number(13) * 1e-6, 0.01, name + "area, Hertz"));
        BOOST_TEST(near_relative(s.fn, number(1), 1e-9, name + "force"));
      }
  }

  /// A sphere: a^3 = 3 F R / (4 E*), p0 = 3 F / (2 pi a^2), approach a^2 / R; the error falls with the grid.
  BOOST_AUTO_TEST_CASE(test_sphere)
  {
    const double stiffness = 210e9 / (2 * (1 - 0.09)), F = 100e3, R = 0.46;
    const double a = std::cbrt(0.75 * F * R / stiffness), p0 = 1.5 * F / (M_PI * a * a);
    double       old_error = 1;
    for (const double dx : {1e-3, 0.5e-3, 0.25e-3})
      {
        const auto s     = solve_rolling(normal_problem(centred_grid(8e-3, 8e-3, dx, dx), R, R, F));
        double     error = 0, norm = 0;
        for (int j = 0; j < s.grid.my; ++j)
          for (int i = 0; i < s.grid.mx; ++i)
            {
              const double r = std::hypot(s.grid.x(i), s.grid.y(j)) / a,
                           p = r < 1 ? p0 * std::sqrt(1 - r * r) : 0;
              error += std::pow(s.pressure[i + s.grid.mx * j] - p, 2);
              norm += p * p;
            }
        error = std::sqrt(error / norm);
        BOOST_TEST(error < 0.6 * old_error,
                   "pressure field of the sphere converges, L2 error " + std::to_string(error));
        old_error = error;
        if (dx < 0.3e-3)
          {
            BOOST_TEST(near_relative(s.peak_pressure, p0, 0.001, "peak pressure of the sphere"));
            BOOST_TEST(near_relative(s.approach, a * a / R, 0.001, "approach of the sphere"));
          }
      }
    BOOST_TEST(old_error < 0.012, "pressure field of the sphere within 1.2 % at 0.25 mm");
  }

  /// A long roller: in its middle the line contact b^2 = 4 F' R / (pi E*), p0 = 2 F' / (pi b).
  BOOST_AUTO_TEST_CASE(test_line)
  {
    const double        stiffness = 210e9 / (2 * (1 - 0.09)), R = 0.46, half = 5e-3;
    const double        line_load = M_PI * stiffness * half * half / (4 * R), length = 1.;
    const HalfspaceGrid grid = centred_grid(6e-3, length / 2, 0.2e-3, 20e-3);
    HalfspaceProblem    problem =
      normal_problem(grid, R, std::numeric_limits<double>::infinity(), line_load * length);
    const auto s      = solve_rolling(problem);
    const int  middle = grid.my / 2;
    double     force = 0, peak = 0;
    for (int i = 0; i < grid.mx; ++i)
      {
        force += s.pressure[i + grid.mx * middle] * grid.dx;
        peak = std::max(peak, s.pressure[i + grid.mx * middle]);
      }
    BOOST_TEST(near_relative(peak,
                             std::sqrt(force * stiffness / (M_PI * R)),
                             0.005,
                             "peak pressure in the middle of a long roller"));
  }

  /// Waves on a sphere: pressure and gap are never negative, nor both positive; force and approach are each
  /// other's inverse; different moduli act through their mean compliance.
  BOOST_AUTO_TEST_CASE(test_rough)
  {
    const HalfspaceGrid grid    = centred_grid(8e-3, 8e-3, 0.25e-3, 0.25e-3);
    HalfspaceProblem    problem = normal_problem(grid, 0.46, 0.46, 50e3);
    problem.undeformed_distance = sampled_distance(grid, [](const double x, const double y) {
      return (x * x + y * y) / 0.92 + 4e-6 * std::sin(3000 * x + 1) * std::cos(2200 * y);
    });
    problem.normal_tolerance    = 1e-9;
    const auto s                = solve_rolling(problem);
    double     lowest_pressure = 1, lowest_gap = 1, worst_product = 0;
    for (int k = 0; k < grid.size(); ++k)
      {
        lowest_pressure = std::min(lowest_pressure, s.pressure[k]);
        lowest_gap      = std::min(lowest_gap, s.gap[k]);
        worst_product =
          std::max(worst_product, std::min(s.pressure[k] / s.peak_pressure, s.gap[k] / s.approach));
      }
    BOOST_TEST(s.converged(), "rough sphere converged to 1e-9");
    BOOST_TEST(
      (s.contact_elements < 0.9 * solve_rolling(normal_problem(grid, 0.46, 0.46, 50e3)).contact_elements),
      "the waves break the contact");
    BOOST_TEST(lowest_pressure >= 0, "pressure never negative");
    BOOST_TEST(lowest_gap >= -1e-9 * (s.approach + 4e-6), "gap never negative");
    BOOST_TEST(worst_product <= 1.1e-9, "gap closed where there is pressure");

    HalfspaceProblem reverse = problem;
    reverse.force_given      = false;
    reverse.approach         = s.approach;
    BOOST_TEST(near_relative(solve_rolling(reverse).fn, s.fn, 1e-7, "force of the approach found"));
    reverse.approach = -1e-3;
    BOOST_TEST(solve_rolling(reverse).fn == 0, "no force without overlap");

    HalfspaceProblem unlike = problem;
    unlike.body1            = {problem.body1.shear_modulus * 2, 0.3};
    unlike.body2            = {problem.body1.shear_modulus * 2 / 3, 0.3};
    BOOST_TEST(near_relative(
      solve_rolling(unlike).approach, s.approach, 1e-7, "unlike bodies of the same mean compliance"));
  }

  BOOST_AUTO_TEST_CASE(test_refusals)
  {
    HalfspaceProblem problem = normal_problem(centred_grid(1e-3, 1e-3, 0.5e-3, 0.5e-3), 1, 1, 1);
    problem.undeformed_distance.pop_back();
    BOOST_TEST((!test::error_of<InputError>([&]() { solve_rolling(problem); }).empty()),
               "an array of another size than the grid is refused");
  }
} // namespace
