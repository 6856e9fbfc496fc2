// label: fast

// Shift, unlike materials, friction over slip velocity and subsurface stresses of the half-space solver
// against closed forms.

#include "near.h"
#include "quadratic_distance.h"

#include <wheelrail/halfspace/influence.h>
#include <wheelrail/halfspace/subsurface_layers.h>

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
  /// Cattaneo (1938), Mindlin (1949): sphere R 50 mm, G 200 MPa, nu 0.42, mu 0.4, a = 1 mm, F = 7/8 mu N:
  /// adhesion within a / 2, tractions mu p0 (sqrt(1 - r^2 / a^2) - sqrt(1 / 4 - r^2 / a^2)), shift 8.172
  /// micrometres.
  BOOST_AUTO_TEST_CASE(test_cattaneo)
  {
    double old_shift = 1, old_field = 1;
    for (const double dx : {0.1e-3, 0.05e-3})
      {
        HalfspaceProblem problem;
        problem.grid                = centred_grid(1.15e-3, 1.15e-3, dx, dx);
        problem.undeformed_distance = quadratic_distance(problem.grid, 0.05, 0.05);
        problem.body1 = problem.body2    = {200e6, 0.42};
        problem.normal_force             = 9.1954;
        problem.friction.at_rest         = 0.4;
        problem.motion                   = HalfspaceMotion::shift;
        problem.longitudinal_force_given = true;
        problem.fx                       = 7. / 8. * 0.4 * problem.normal_force;
        problem.lateral_force_given      = true;
        const auto   s                   = solve_rolling(problem);
        const double a = 1e-3, p0 = 1.5 * problem.normal_force / (M_PI * a * a);
        double       error = 0, norm = 0;
        for (int j = 0; j < s.grid.my; ++j)
          for (int i = 0; i < s.grid.mx; ++i)
            {
              const double r2 = (std::pow(s.grid.x(i), 2) + std::pow(s.grid.y(j), 2)) / (a * a);
              const double t =
                0.4 * p0 * (std::sqrt(std::max(0., 1 - r2)) - std::sqrt(std::max(0., 0.25 - r2)));
              error += std::pow(s.traction_x[i + s.grid.mx * j] - t, 2);
              norm += t * t;
            }
        error = std::sqrt(error / norm);
        const double shift =
          3 * 0.4 * problem.normal_force / (16 * a) * 2 * 1.58 / 200e6 * (1 - std::pow(1. / 8, 2. / 3));
        BOOST_TEST(s.converged(), "Cattaneo converged");
        BOOST_TEST(near_relative(-s.xi, shift, 0.01, "Cattaneo's shift"));
        BOOST_TEST(near(
          std::sqrt(s.adhesion_area / M_PI), 0.5e-3, 0.5 * dx, "radius of adhesion within half an element"));
        BOOST_TEST(error < old_field, "Cattaneo's tractions, L2 error " + std::to_string(error));
        old_field = error;
        old_shift = std::abs(-s.xi / shift - 1);
      }
    BOOST_TEST((old_field < 0.04 && old_shift < 0.01),
               "Cattaneo within 4 % (field; the formula neglects the cross slip), 1 % (shift)");
  }

  /// Unlike materials. A line contact under p: the surfaces are strained by -2 K / G p relative to each other
  /// (plane strain). Swapping the bodies, seen from the other side, changes nothing.
  BOOST_AUTO_TEST_CASE(test_unlike)
  {
    HalfspaceProblem line;
    line.grid                = {121, 1, 0.1e-3, 2., -6e-3, 0};
    line.undeformed_distance = quadratic_distance(line.grid, 0.46, std::numeric_limits<double>::infinity());
    line.normal_force        = 6e6;
    line.motion              = HalfspaceMotion::none;
    line.body1               = {27e9, 0.33};
    const auto   s           = solve_rolling(line);
    const double k_over_g    = M_PI * halfspace_constants(line.body1, line.body2).coupling;
    BOOST_TEST(near_relative(k_over_g, (0.34 / 27e9 - 0.4 / (210e9 / 2.6)) / 4, 1e-12, "K / G"));
    double error = 0;
    for (int i = 40; i <= 80; ++i)
      error = std::max(error,
                       std::abs((s.displacement_x[i + 1] - s.displacement_x[i - 1]) / 0.2e-3 +
                                2 * k_over_g * s.pressure[i]));
    BOOST_TEST(error < 0.005 * 2 * k_over_g * s.peak_pressure, "strain of unlike surfaces under pressure");

    HalfspaceProblem a;
    a.grid                = centred_grid(9e-3, 8e-3, 0.5e-3, 0.5e-3);
    a.undeformed_distance = quadratic_distance(a.grid, 0.46, 0.3);
    a.normal_force        = 100e3;
    a.body1               = {27e9, 0.25};
    a.xi                  = 1.5e-3;
    a.coupling_tolerance  = 1e-6;
    HalfspaceProblem b    = a;
    std::swap(b.body1, b.body2);
    b.xi          = -a.xi;
    const auto sa = solve_rolling(a), sb = solve_rolling(b);
    BOOST_TEST((sa.converged() && sa.coupling_rounds < 20),
               "coupling settles in " + std::to_string(sa.coupling_rounds) + " rounds");
    BOOST_TEST(near_relative(sb.fx, -sa.fx, 1e-4, "force of swapped bodies"));
    BOOST_TEST(near_relative(sb.peak_shear, sa.peak_shear, 1e-3, "peak shear of swapped bodies"));
    double gap = 0, moment = 0;
    for (int j = 0; j < a.grid.my; ++j)
      for (int i = 0; i < a.grid.mx; ++i)
        {
          const int e = i + a.grid.mx * j;
          gap         = std::max(gap, sa.pressure[e] > 0 ? std::abs(sa.gap[e]) : -sa.gap[e]);
          moment += a.grid.x(i) * sa.pressure[e] * a.grid.element_area();
        }
    BOOST_TEST(gap < 1e-4 * sa.approach, "gap with the displacement of the tractions closed in the contact");
    BOOST_TEST(std::abs(moment) > 0.01e-3 * 100e3,
               "tractions move the pressure, by [mm] " + std::to_string(moment / 100));
  }

  /// mu falls with the slip velocity; every slipping element carries mu(v) p.
  BOOST_AUTO_TEST_CASE(test_friction_laws)
  {
    for (const auto kind : {FrictionKind::rational, FrictionKind::exponential})
      {
        HalfspaceProblem problem;
        problem.grid                = centred_grid(8e-3, 6.5e-3, 0.5e-3, 0.5e-3);
        problem.undeformed_distance = quadratic_distance(problem.grid, 0.46, 0.3);
        problem.normal_force        = 100e3;
        problem.xi                  = 4e-3;
        problem.velocity            = 30;
        problem.friction            = {0.5, kind, 0.3, 2, 0.5};
        const auto s                = solve_rolling(problem);
        double     error            = 0;
        for (int e = 0; e < problem.grid.size(); ++e)
          if (s.state[e] == HalfspaceSolution::slip)
            error = std::max(error,
                             std::abs(std::hypot(s.traction_x[e], s.traction_y[e]) / s.pressure[e] -
                                      problem.friction.at(30 * std::hypot(s.slip_x[e], s.slip_y[e]))));
        BOOST_TEST((s.converged() && s.slip_area > 0.3 * s.area), "friction over slip velocity settled");
        BOOST_TEST(error < 2e-4,
                   "tractions over pressure are the law's, largest difference " + std::to_string(error));
        problem.friction.kind = FrictionKind::constant;
        BOOST_TEST(std::abs(s.fx) < 0.99 * std::abs(solve_rolling(problem).fx),
                   "falling friction lowers the force");
      }
  }

  /// Sphere, nu 0.3: on the axis largest von Mises 0.6200 p0 at 0.481 a, at the surface sigma_x = -(1 + 2 nu)
  /// / 2 p0. Line: largest orthogonal shear p0 / 4 at x = 0.866 a, z = a / 2. Surface: the tractions; below:
  /// equilibrium.
  BOOST_AUTO_TEST_CASE(test_subsurface)
  {
    HalfspaceProblem sphere;
    sphere.grid                = centred_grid(7.2e-3, 7.2e-3, 0.2e-3, 0.2e-3);
    sphere.undeformed_distance = quadratic_distance(sphere.grid, 0.46, 0.46);
    sphere.normal_force        = 100e3;
    sphere.xi                  = 2e-3;
    HalfspaceProblem smooth    = sphere;
    smooth.motion              = HalfspaceMotion::none;
    const auto   s             = solve_rolling(smooth);
    const double a = 6.6869e-3, p0 = 1067.81e6;
    const auto   at = [&](const HalfspaceSolution &solution, double x, double y, double depth) {
      return subsurface_stresses(solution, sphere.body1, HalfspaceSide::body1, {{x, y, depth}})[0];
    };
    BOOST_TEST(
      near_relative(at(s, 0, 0, 0.481 * a).von_mises(), 0.62 * p0, 0.002, "von Mises below a sphere"));
    BOOST_TEST((at(s, 0, 0, 0.45 * a).von_mises() < at(s, 0, 0, 0.481 * a).von_mises() &&
                at(s, 0, 0, 0.51 * a).von_mises() < at(s, 0, 0, 0.481 * a).von_mises()),
               "its largest value lies at 0.481 a");
    BOOST_TEST(near_relative(at(s, 0, 0, 0).xx, -0.8 * p0, 0.005, "sigma_x at the surface below a sphere"));
    BOOST_TEST(near_relative(at(s, 0, 0, 0).nn, -s.peak_pressure, 1e-6, "sigma_n at the surface"));

    HalfspaceProblem line;
    line.grid                = {121, 1, 0.1e-3, 2., -6e-3, 0};
    line.undeformed_distance = quadratic_distance(line.grid, 0.46, std::numeric_limits<double>::infinity());
    line.normal_force        = 6e6;
    line.motion              = HalfspaceMotion::none;
    const auto   l           = solve_rolling(line);
    const double half        = 2 * line.normal_force / (2. * M_PI * l.peak_pressure);
    BOOST_TEST(near_relative(std::abs(at(l, 0.866 * half, 0, 0.5 * half).xn),
                             0.25 * l.peak_pressure,
                             0.003,
                             "orthogonal shear below a line contact"));
    BOOST_TEST(near_relative(at(l, 0, 0, 0.704 * half).von_mises(),
                             0.5575 * l.peak_pressure,
                             0.003,
                             "von Mises below a line contact"));

    const auto rolling = solve_rolling(sphere);
    const int  i = 20, j = 30, e = i + sphere.grid.mx * j;
    const auto top = at(rolling, sphere.grid.x(i), sphere.grid.y(j), 0);
    BOOST_TEST(near_relative(top.xn, -rolling.traction_x[e], 1e-9, "sigma_xn at the surface of body 1"));
    BOOST_TEST(
      near(top.yn, -rolling.traction_y[e], 1e-9 * rolling.peak_shear, "sigma_yn at the surface of body 1"));
    const auto below = subsurface_stresses(
      rolling, sphere.body2, HalfspaceSide::body2, {{sphere.grid.x(i), sphere.grid.y(j), 0}})[0];
    BOOST_TEST(near_relative(below.xn, -rolling.traction_x[e], 1e-9, "sigma_xn is the same in body 2"));
    // layers by FFT against sums over the elements
    for (const auto side : {HalfspaceSide::body1, HalfspaceSide::body2})
      {
        const HalfspaceBody &body = side == HalfspaceSide::body1 ? sphere.body1 : sphere.body2;
        SubsurfaceLayers     layers(rolling, sphere.body1, sphere.body2);
        double               worst = 0;
        for (const double depth : {0., 0.3e-3, 3e-3})
          {
            const LayerStresses   both  = layers.at(depth);
            const HalfspaceStress layer = (side == HalfspaceSide::body1 ? both.body1 : both.body2)[e];
            const HalfspaceStress sum =
              subsurface_stresses(rolling, body, side, {{sphere.grid.x(i), sphere.grid.y(j), depth}})[0];
            for (const auto c : {&HalfspaceStress::xx,
                                 &HalfspaceStress::yy,
                                 &HalfspaceStress::nn,
                                 &HalfspaceStress::xy,
                                 &HalfspaceStress::xn,
                                 &HalfspaceStress::yn})
              worst = std::max(worst, std::abs(layer.*c - sum.*c));
          }
        BOOST_TEST(near(worst / p0, 0, 1e-12, "layers against sums over the elements, over p0"));
      }
    // div sigma = 0 by central differences inside body 1.
    const double h = 0.02e-3, x = 2e-3, y = 1e-3, z = 2e-3;
    const auto   px = at(rolling, x + h, y, z), mx = at(rolling, x - h, y, z), py = at(rolling, x, y + h, z),
               my = at(rolling, x, y - h, z), pz = at(rolling, x, y, z + h), mz = at(rolling, x, y, z - h);
    const double scale = p0 / a;
    BOOST_TEST(near(
      (px.xx - mx.xx + py.xy - my.xy + pz.xn - mz.xn) / (2 * h) / scale, 0, 1e-4, "equilibrium along x"));
    BOOST_TEST(near(
      (px.xy - mx.xy + py.yy - my.yy + pz.yn - mz.yn) / (2 * h) / scale, 0, 1e-4, "equilibrium along y"));
    BOOST_TEST(near(
      (px.xn - mx.xn + py.yn - my.yn + pz.nn - mz.nn) / (2 * h) / scale, 0, 1e-4, "equilibrium along n"));
  }
} // namespace
