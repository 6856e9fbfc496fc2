// Thick cylinder and thick sphere under internal pressure, loaded beyond yield and unloaded, without
// hardening: plastic front, displacement, stresses under load and residual stresses.

#include "scenes/dynamics.h"

#include "check.h"

#include <algorithm>

using namespace scenes;
using namespace wheelrail;

namespace
{
  constexpr double inner = 0.1, outer = 0.2;

  /// Hill, The Mathematical Theory of Plasticity, 1950, chapter 5. k: flow stress of the difference of hoop
  /// and radial stress; n = 2 for the cylinder, 3 for the sphere.
  struct Vessel
  {
    int    n;
    double flow; ///< hoop minus radial stress in the plastic part [Pa]

    /// Pressure at which the plastic front is at c [Pa].
    double
    pressure(const double c) const
    {
      const double ratio = std::pow(c / outer, n);
      return n == 2 ? flow * (std::log(c / inner) + (1 - ratio) / 2)
                    : 2 * flow * std::log(c / inner) + 2. / 3 * flow * (1 - ratio);
    }
    /// Radial and hoop stress at r with the front at c.
    std::array<double, 2>
    stress(const double r, const double c) const
    {
      const double b = std::pow(c / outer, n);
      if (r >= c)
        {
          const double x = std::pow(outer / r, n);
          return n == 2 ? std::array<double, 2>{flow / 2 * b * (1 - x), flow / 2 * b * (1 + x)}
                        : std::array<double, 2>{2. / 3 * flow * b * (1 - x), 2. / 3 * flow * b * (1 + x / 2)};
        }
      const double radial = (n == 2 ? flow : 2 * flow) * std::log(r / inner) - pressure(c);
      return {radial, radial + flow};
    }
    /// Elastic stresses under the pressure p (Lame).
    std::array<double, 2>
    elastic(const double r, const double p) const
    {
      const double f = p / (std::pow(outer / inner, n) - 1), x = std::pow(outer / r, n);
      return {f * (1 - x), f * (1 + x / (n - 1))};
    }
    /// Displacement of the outer surface [m].
    double
    outer_displacement(const double c, const Elasticity &m) const
    {
      const double nu = m.poissons_ratio, b = std::pow(c / outer, n);
      return n == 2 ? flow * b * outer * (1 - nu * nu) / m.youngs_modulus
                    : flow * b * outer * (1 - nu) / m.youngs_modulus;
    }
  };

  struct Measures
  {
    double front = 0, displacement = 0, radial = 0, hoop = 0, residual = 0;
    Energy energy;
  };

  /// Radius, radial and hoop stress of an element.
  std::array<double, 3>
  in_polar(const Dynamics &scene, const std::size_t element, const std::array<double, 6> &s, const int n)
  {
    Vector3 X{};
    for (const unsigned int node : scene.solid.mesh.cells[scene.solid.block_cells[1][element]])
      add(X, 1. / 8, place_of(scene.solid.mesh, node));
    if (n == 2)
      X[2] = 0;
    const Vector3 e      = normalised(X);
    const double  radial = e[0] * e[0] * s[0] + e[1] * e[1] * s[1] + e[2] * e[2] * s[2] +
                          2 * (e[1] * e[2] * s[3] + e[0] * e[2] * s[4] + e[0] * e[1] * s[5]);
    const double trace = s[0] + s[1] + s[2];
    return {norm(X), radial, n == 2 ? trace - radial - s[2] : (trace - radial) / 2};
  }

  /// Radius where the plastic strain vanishes [m]. In the exact solution it is proportional to (c/r)^n - 1
  /// (in the cylinder nearly so): root of the straight line over r^-n through the plastic cells, without
  /// those that the front may cross.
  double
  plastic_front(const Dynamics &scene, const int n)
  {
    const auto strain = element_plastic_strain(scene.solid.blocks[1]);
    double     last   = 0;
    for (std::size_t e = 0; e < strain.size(); ++e)
      if (strain[e] > 0)
        last = std::max(last, in_polar(scene, e, {}, n)[0]);
    double sum[5] = {0, 0, 0, 0, 0};
    for (std::size_t e = 0; e < strain.size(); ++e)
      if (const double r = in_polar(scene, e, {}, n)[0]; r < 0.95 * last && r > 0.75 * last)
        {
          const double x       = std::pow(outer / r, n);
          const double part[5] = {1, x, strain[e], x * x, x * strain[e]};
          for (int k = 0; k < 5; ++k)
            sum[k] += part[k];
        }
    const double slope = (sum[0] * sum[4] - sum[1] * sum[2]) / (sum[0] * sum[3] - sum[1] * sum[1]);
    const double root  = sum[1] / sum[0] - sum[2] / sum[0] / slope;
    return outer / std::pow(root, 1. / n);
  }

  /// Loads to the front c and unloads.
  Measures
  load(Setup setup, const Vessel &vessel, LocalMesh mesh, const double c)
  {
    const Elasticity &m    = setup.material;
    const double      mean = 0.5 * (inner + outer), omega = std::sqrt(m.youngs_modulus / m.density) / mean;
    setup.mass_damping = omega;
    const double ramp = 60 / omega, hold = 40 / omega, p = vessel.pressure(c);
    Dynamics     scene(std::move(mesh), setup);
    const auto  &nodes  = scene.solid.mesh;
    const auto   radius = [&](const Vector3 &X) { return vessel.n == 2 ? std::hypot(X[0], X[1]) : norm(X); };
    const double middle = inner + 0.2 * (outer - inner);
    for (const int component : {0, 1, 2})
      scene.fix(vessel.n == 2 && component == 2 ? select(nodes, [](const Vector3 &) { return true; })
                                                : select(nodes, plane(component, 0)),
                component);
    scene.press(select_faces(nodes,
                             [&](const Vector3 &X) {
                               const bool inside =
                                 X[0] > 1e-6 && X[1] > 1e-6 && (vessel.n == 2 || X[2] > 1e-6);
                               return inside && radius(X) < inner + 1e-4 * middle;
                             }),
                [=](const double t) {
                  const double up   = std::min(1., t / ramp),
                               down = std::clamp((t - ramp - hold) / ramp, 0., 1.);
                  return p * (up * up * (3 - 2 * up) - down * down * (3 - 2 * down));
                });
    Measures   result;
    const auto compare = [&](const bool loaded) {
      const auto stress = element_stress(scene.solid.blocks[1], scene.solid.displacement.data());
      for (std::size_t e = 0; e < stress.size(); ++e)
        {
          const auto [r, radial, hoop] = in_polar(scene, e, stress[e], vessel.n);
          auto exact                   = vessel.stress(r, c);
          if (loaded)
            {
              result.radial = std::max(result.radial, std::abs(radial - exact[0]));
              result.hoop   = std::max(result.hoop, std::abs(hoop - exact[1]));
            }
          else
            for (int k = 0; k < 2; ++k)
              result.residual = std::max(
                result.residual, std::abs((k == 0 ? radial : hoop) - exact[k] + vessel.elastic(r, p)[k]));
        }
    };
    scene.run_to(ramp + hold);
    scene.step(true);
    compare(true);
    result.front = plastic_front(scene, vessel.n);
    double count = 0;
    for (const unsigned int node :
         select(nodes, [&](const Vector3 &X) { return radius(X) > 0.9999 * outer; }))
      {
        const Vector3 X = place_of(nodes, node);
        const double *u = &scene.solid.displacement[4 * node];
        result.displacement +=
          (vessel.n == 2 ? X[0] * u[0] + X[1] * u[1] : dot(X, {u[0], u[1], u[2]})) / outer;
        ++count;
      }
    result.displacement /= count;
    scene.run_to(2 * (ramp + hold));
    scene.step(true);
    compare(false);
    result.energy = scene.energy();
    return result;
  }

  void
  vessel(const Setup &setup, const int n, const unsigned int radial, const double c)
  {
    const double      Y = setup.plasticity.yield_stress;
    const Vessel      exact{n, n == 2 ? 2 * Y / std::sqrt(3.) : Y};
    const LocalMesh   mesh = n == 2 ? quarter_cylinder(inner, outer, 5e-3, {radial, radial, 1}, 1.5)
                                    : sphere_octant(inner, outer, radial, radial / 2, 1.5);
    const Measures    m    = load(setup, exact, mesh, c);
    const double      p    = exact.pressure(c);
    const std::string name = form_name(setup) + (n == 2 ? ", cylinder, " : ", sphere, ") + "front at " +
                             std::to_string(int(1e3 * c)) + " mm: ";
    std::cout << "        " << mesh.cells.size() << " cells, pressure " << p * 1e-6 << " MPa, front "
              << 1e3 * m.front << " mm, outer displacement " << 1e6 * m.displacement << " um\n";
    test::check_near(
      exact.pressure(m.front) / p, 1, 0.01, name + "exact pressure of the front found over that applied");
    test::check_near(m.displacement / exact.outer_displacement(c, setup.material),
                     1,
                     0.01,
                     name + "displacement of the outer surface over the exact one");
    test::check_near(m.radial / Y, 0, 0.02, name + "radial stress, largest error over the yield stress");
    test::check_near(m.hoop / Y, 0, 0.02, name + "hoop stress, largest error over the yield stress");
    test::check_near(
      m.residual / Y, 0, 0.02, name + "residual stresses, largest error over the yield stress");
    test::check_near(m.energy.error(), 0, 0.01, name + "energy error");
  }
} // namespace

int
main(int argc, char **argv)
{
  Program program(argc, argv);
  Setup   base;
  base.plasticity.yield_stress = 240e6;
  for (const Setup &setup : each_form(base))
    {
      vessel(setup, 2, 16, 0.14);
      vessel(setup, 2, 16, 0.16);
      vessel(setup, 3, 16, 0.14);
    }
  return test::report();
}
