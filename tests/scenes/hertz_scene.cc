#include "hertz_scene.h"

#include <wheelrail/sampling/patch_measures.h>
#include <wheelrail/solid/kernel.h>
#include <wheelrail/solid/point_state.h>
#include <wheelrail/solid/stress_recovery.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <map>
#include <string>
#include <vector>

namespace scenes
{
  using namespace wheelrail;

  namespace
  {
    // Two bodies of twice the radius against each other: one of them against the rigid plane of symmetry.
    // The load is small, since Hertz knows no finite strains; the patch is that of 100 kN on a tenth of the
    // radii
    constexpr double radius = 9.2, crown = 6, ramp = 80e-6, end = 400e-6;

    /// The exact solution; `load` is that of the whole body, or of a strip one cell wide.
    struct Exact
    {
      Hertz  solution;
      double load, area, mises, depth;
    };

    Exact
    exact(const HertzShape shape, const double cell, const double load, const Elasticity &material)
    {
      const double nu = material.poissons_ratio, modulus = material.youngs_modulus / (1 - nu * nu);
      Exact        result;
      if (shape == HertzShape::line)
        {
          const double a  = 5e-3;
          result.solution = {a, 0, modulus * a / (2 * radius), 0};
          result.load     = 0.5 * M_PI * a * result.solution.peak * cell;
          result.area     = a;
          // nu = 0.3, plane strain (McEwen's field)
          result.mises = 0.5575 * result.solution.peak;
          result.depth = 0.704 * a;
          return result;
        }
      result.solution = hertz(0.1 * load, radius, shape == HertzShape::point ? radius : crown, modulus);
      result.load     = 0.1 * load;
      result.area     = M_PI * result.solution.a * result.solution.b;
      // nu = 0.3; the ellipse from CONTACT's subsurface stresses at these radii
      result.mises = (shape == HertzShape::point ? 0.6200 : 0.618) * result.solution.peak;
      result.depth = shape == HertzShape::point ? 0.481 * result.solution.a : 2.9e-3 * std::cbrt(load / 1e5);
      return result;
    }

    /// Displacement of the half-plane under a line load of 1 N/m (Flamant 1892), plane strain.
    Vector3
    flamant(const Vector3 &X, const Elasticity &material)
    {
      const double nu = material.poissons_ratio, depth = -X[1], z = X[2], rho2 = depth * depth + z * z;
      const double factor = (1 + nu) / (M_PI * material.youngs_modulus);
      const double down   = factor * (depth * depth / rho2 - (1 - nu) * std::log(rho2));
      const double out    = factor * (depth * z / rho2 - (1 - 2 * nu) * std::atan2(z, depth));
      return {0, -down, out};
    }

    Vector3
    far_displacement(const HertzShape shape, const Vector3 &X, const Hertz &h, const Elasticity &material)
    {
      if (shape != HertzShape::line)
        return under_ellipse(X, h.a, h.b, material);
      constexpr int n = 40;
      Vector3       u{};
      double        sum = 0;
      for (int k = 0; k < n; ++k)
        {
          const double q = -1 + (2 * k + 1.) / n, weight = std::sqrt(1 - q * q);
          add(u, weight, flamant(X - Vector3{0, 0, q * h.a}, material));
          sum += weight;
        }
      return (1 / sum) * u;
    }

    /// Largest value of f at equal spacing and its place, by the parabola through the top three.
    std::array<double, 2>
    top(const std::vector<double> &x, const std::vector<double> &f)
    {
      const std::size_t k =
        std::clamp<std::size_t>(std::max_element(f.begin(), f.end()) - f.begin(), 1, f.size() - 2);
      const double h1 = x[k] - x[k - 1], h2 = x[k + 1] - x[k];
      const double d1 = (f[k] - f[k - 1]) / h1, d2 = (f[k + 1] - f[k]) / h2;
      const double second = (d2 - d1) / (h1 + h2), slope = (d1 * h2 + d2 * h1) / (h1 + h2);
      const double t = -slope / (2 * second);
      return {x[k] + t, f[k] + slope * t + second * t * t};
    }

    /// Depth and size of the largest von Mises stress below the origin, from the centres of the elements
    /// along the axis.
    std::array<double, 2>
    below(const Solid &solid, const double cell)
    {
      const auto               stress = element_stress(solid.blocks.rail, solid.displacement.data());
      std::map<double, double> mises;
      for (std::size_t e = 0; e < stress.size(); ++e)
        {
          Vector3 X{};
          for (const unsigned int n : solid.mesh.cells[solid.block_cells.rail[e]])
            add(X, 0.125, place_of(solid.mesh, n));
          if (X[0] < cell && X[2] < cell && X[1] > -12e-3)
            mises[-X[1]] = von_mises(stress[e].data());
        }
      std::vector<double> depth, value;
      for (const auto &[d, m] : mises)
        {
          depth.push_back(d);
          value.push_back(m);
        }
      return top(depth, value);
    }

    /// Nodal stress across the load in the origin, on the surface [Pa].
    double
    stress_on_surface(const Solid &solid)
    {
      const auto stress = nodal_stress(solid).stress;
      for (unsigned int n = 0; n < solid.mesh.n_nodes(); ++n)
        if (norm(place_of(solid.mesh, n)) < 1e-9)
          return stress[6 * n];
      return 0;
    }

    double
    loading(const double time)
    {
      const double t = std::min(1., time / ramp);
      return t * t * (3 - 2 * t);
    }
  } // namespace


  HertzRun
  run_hertz(const HertzShape shape,
            const double     cell,
            const double     scale,
            const bool       filter,
            const double     load_of_radii)
  {
    const bool   line = shape == HertzShape::line;
    Setup        setup;
    const Exact  truth = exact(shape, cell, load_of_radii, setup.material);
    const double load  = truth.load;
    // two cells beside the patch are free of load
    const double fine = line ? 8e-3 : std::max(10e-3, cell * std::ceil((truth.solution.a + 2.5e-3) / cell));
    const auto   half = fine_then_coarse(cell, fine, 40e-3), deep = fine_then_coarse(cell, 6e-3, 40e-3);
    LocalMesh    mesh = rail_block(line ? std::vector<double>{0, cell} : half, deep, half);

    // boundaries: planes of symmetry, and the half-space's displacement on the outer faces
    Dynamics scene(std::move(mesh), setup);
    scene.mass_damping = 1.5e5;
    const auto &nodes  = scene.solid.mesh;
    scene.fix(select(nodes, plane(2, 0)), 2);
    scene.fix(line ? select(nodes, [](const Vector3 &) { return true; }) : select(nodes, plane(0, 0)), 0);
    const double per_load = line ? load / cell : load;
    for (const unsigned int n : select(nodes, [&](const Vector3 &X) {
           return std::abs(X[2]) > half.back() - 1e-9 || -X[1] > deep.back() - 1e-9 ||
                  (!line && std::abs(X[0]) > half.back() - 1e-9);
         }))
      {
        const Vector3 u =
          per_load * far_displacement(shape, place_of(nodes, n), truth.solution, setup.material);
        for (int i = 0; i < 3; ++i)
          scene.prescribe({n}, i, [value = u[i]](const double time) { return value * loading(time); });
      }

    const RunningSurfaces surfaces = wheel_on_plane(radius,
                                                    shape == HertzShape::point ? radius
                                                    : line                     ? 0
                                                                               : crown,
                                                    30e-3);
    const CellRange       along = {0, fine, cell}, everywhere = {-fine, fine, cell};
    const Lattice         rail = make_lattice(along, line ? CellRange{0, cell, cell} : along);
    ContactSetup          contact;
    contact.scale     = 2 * scale; // half the gap belongs to each body
    contact.cell_size = cell;
    contact.filter    = filter;
    contact.symmetry  = {!line, true};
    ContactPair pair(
      scene,
      surfaces,
      make_surface(nodes, Body::rail, surfaces, rail, MPI_COMM_SELF),
      rigid_surface(surfaces, make_lattice(everywhere, line ? CellRange{-cell, 2 * cell, cell} : everywhere)),
      contact);
    // the wheel swings on its contact as slowly as the block: light ones are unstable on the stiff layer
    const double frequency = 1.2e5;
    const double mass      = load / (line ? 4e-6 : truth.solution.approach) / (frequency * frequency);
    pair.drive             = [&](const double time, RigidWheel &wheel) {
      advance(wheel.move[1],
              wheel.velocity[1],
              (pair.sums.force[1] - load * loading(time)) / mass,
              make_velocity_update(scene.time_step, scene.mass_damping),
              scene.time_step);
    };

    const std::clock_t start = std::clock();
    scene.run_to(end);
    HertzRun run;
    run.seconds  = double(std::clock() - start) / CLOCKS_PER_SEC;
    run.steps    = scene.steps();
    run.elements = nodes.cells.size();

    const PatchMeasures measures = measure_patch(pair.patch());
    const auto          stress   = below(scene.solid, cell);
    run.peak_pressure            = truth.solution.peak;
    run.penetration              = 2 * pair.sums.largest_pressure / pair.contact.law().stiffness;
    run.peak                     = measures.peak_pressure / truth.solution.peak - 1;
    run.approach                 = line ? 0 : -pair.wheel.move[1] / truth.solution.approach - 1;
    run.area                     = (line ? 0.5 * measures.length : measures.area) / truth.area - 1;
    run.depth                    = stress[0] / truth.depth - 1;
    run.mises                    = stress[1] / truth.mises - 1;
    run.surface                  = stress_on_surface(scene.solid) / truth.solution.peak;
    run.force                    = pair.sums.force[1] / load - 1;
    return run;
  }


  std::string
  hertz_row(const HertzShape shape, const double cell, const double scale, const HertzRun *run)
  {
    const char *names[] = {"point", "ellipse", "line"};
    char        line[200];
    if (run == nullptr)
      std::snprintf(line,
                    sizeof(line),
                    "%-8s %6s %6s %9s %9s %9s %9s %9s %9s %7s %9s",
                    "shape",
                    "h [mm]",
                    "f",
                    "peak %",
                    "approach %",
                    "area %",
                    "Mises %",
                    "depth %",
                    "elements",
                    "steps",
                    "CPU [s]");
    else
      std::snprintf(line,
                    sizeof(line),
                    "%-8s %6g %6g %9.2f %9.2f %9.2f %9.2f %9.2f %9.0f %7.0f %9.2f",
                    names[int(shape)],
                    1e3 * cell,
                    scale,
                    100 * run->peak,
                    100 * run->approach,
                    100 * run->area,
                    100 * run->mises,
                    100 * run->depth,
                    run->elements,
                    run->steps,
                    run->seconds);
    return line;
  }
} // namespace scenes
