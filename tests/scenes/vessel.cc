#include <wheelrail/solid/point_state.h>

#include "vessel.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace scenes
{
  using namespace wheelrail;

  namespace
  {
    /// Radius, radial and hoop stress of an element.
    std::array<double, 3>
    in_polar(const Dynamics &scene, const std::size_t element, const std::array<double, 6> &s, const int n)
    {
      Vector3 X{};
      for (const unsigned int node : scene.solid.mesh.cells[scene.solid.block_cells.wheel[element]])
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
      const auto strain = element_plastic_strain(scene.solid.blocks.wheel);
      double     last   = 0;
      for (std::size_t e = 0; e < strain.size(); ++e)
        if (strain[e] > 0)
          last = std::max(last, in_polar(scene, e, {}, n)[0]);
      double sum[5] = {0, 0, 0, 0, 0};
      for (std::size_t e = 0; e < strain.size(); ++e)
        if (const double r = in_polar(scene, e, {}, n)[0]; r < 0.95 * last && r > 0.75 * last)
          {
            const double x       = std::pow(outer_radius / r, n);
            const double part[5] = {1, x, strain[e], x * x, x * strain[e]};
            for (int k = 0; k < 5; ++k)
              sum[k] += part[k];
          }
      const double slope = (sum[0] * sum[4] - sum[1] * sum[2]) / (sum[0] * sum[3] - sum[1] * sum[1]);
      const double root  = sum[1] / sum[0] - sum[2] / sum[0] / slope;
      return outer_radius / std::pow(root, 1. / n);
    }

    /// Mean outward displacement of the nodes of the outer surface [m].
    double
    surface_displacement(const Dynamics &scene, const int n)
    {
      double     sum = 0, count = 0;
      const auto radius = [n](const Vector3 &X) { return n == 2 ? std::hypot(X[0], X[1]) : norm(X); };
      for (const unsigned int node :
           select(scene.solid.mesh, [&](const Vector3 &X) { return radius(X) > 0.9999 * outer_radius; }))
        {
          const Vector3 X = place_of(scene.solid.mesh, node);
          const double *u = &scene.solid.displacement[4 * node];
          sum += (n == 2 ? X[0] * u[0] + X[1] * u[1] : dot(X, {u[0], u[1], u[2]})) / outer_radius;
          ++count;
        }
      return sum / count;
    }
  } // namespace


  VesselState
  load_vessel(Setup setup, const Vessel &vessel, LocalMesh mesh, const double c)
  {
    const Elasticity &m    = setup.material;
    const double      mean = 0.5 * (inner_radius + outer_radius),
                 omega     = std::sqrt(m.youngs_modulus / m.density) / mean;
    setup.mass_damping     = omega;
    const double ramp = 60 / omega, hold = 40 / omega, p = vessel.pressure(c);
    Dynamics     scene(std::move(mesh), setup);
    const auto  &nodes  = scene.solid.mesh;
    const auto   radius = [&](const Vector3 &X) { return vessel.n == 2 ? std::hypot(X[0], X[1]) : norm(X); };
    const double middle = inner_radius + 0.2 * (outer_radius - inner_radius);
    for (const int component : {0, 1, 2})
      scene.fix(vessel.n == 2 && component == 2 ? select(nodes, [](const Vector3 &) { return true; })
                                                : select(nodes, plane(component, 0)),
                component);
    scene.press(select_faces(nodes,
                             [&](const Vector3 &X) {
                               const bool inside =
                                 X[0] > 1e-6 && X[1] > 1e-6 && (vessel.n == 2 || X[2] > 1e-6);
                               return inside && radius(X) < inner_radius + 1e-4 * middle;
                             }),
                [=](const double t) {
                  const double up   = std::min(1., t / ramp),
                               down = std::clamp((t - ramp - hold) / ramp, 0., 1.);
                  return p * (up * up * (3 - 2 * up) - down * down * (3 - 2 * down));
                });
    VesselState result;
    const auto  compare = [&](const bool loaded) {
      const auto stress = element_stress(scene.solid.blocks.wheel, scene.solid.displacement.data());
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
    result.front        = plastic_front(scene, vessel.n);
    result.displacement = surface_displacement(scene, vessel.n);
    scene.run_to(2 * (ramp + hold));
    scene.step(true);
    compare(false);
    result.energy = scene.energy();
    return result;
  }
} // namespace scenes
