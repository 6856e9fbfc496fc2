#include "rolling_pair.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <ctime>
#include <vector>

namespace scenes
{
  using namespace wheelrail;

  namespace
  {
    /// Fine cells from `begin` to `end`, coarser ones for 40 mm beyond.
    std::vector<double>
    along_rail(const double begin, const double end, const double cell)
    {
      const auto          beyond = fine_then_coarse(cell, 0, 40e-3, 1.3);
      std::vector<double> z;
      for (std::size_t k = beyond.size(); k-- > 1;)
        z.push_back(begin - beyond[k]);
      const int n = std::lround((end - begin) / cell);
      for (int k = 0; k <= n; ++k)
        z.push_back(begin + k * cell);
      for (std::size_t k = 1; k < beyond.size(); ++k)
        z.push_back(z[z.size() - 1] + beyond[k] - beyond[k - 1]);
      return z;
    }

    std::vector<double>
    across(const RollingPairSetup &setup, const double cell)
    {
      if (setup.strip)
        return {0, setup.cell};
      const auto half = fine_then_coarse(cell, setup.fine_across, setup.width, 1.3);
      return setup.whole ? both_sides(half) : half;
    }

    CellRange
    fine_across(const RollingPairSetup &setup, const double cell)
    {
      if (setup.strip)
        return {0, setup.cell, setup.cell};
      const double end = cell * std::lround(setup.fine_across / cell);
      return {setup.whole ? -end : 0., end, cell};
    }

    /// Where the wheel is at a time: it rolls on a circle whose curvature is the spin, heading along it.
    struct Path
    {
      const RollingPairSetup &setup;

      double
      height(const double way) const
      {
        const double t = std::min(1., way / setup.ramp);
        return -setup.descent * t * t * (3 - 2 * t);
      }

      /// Place of a point of the rigid wheel.
      Vector3
      place(const Vector3 &X, const double time) const
      {
        const Vector3 centre = {0, setup.radius, 0};
        const double  way = setup.velocity * time, heading = setup.spin * way;
        const double  turned = way * (1 + setup.creepage) / setup.radius;
        // sin(h)/h and (1 - cos(h))/h without dividing by nothing
        const double  ahead = heading == 0 ? way : std::sin(heading) / setup.spin;
        const double  aside = heading == 0 ? 0 : (1 - std::cos(heading)) / setup.spin;
        const Vector3 arm   = Rotation({0, 1, 0}, heading)(Rotation({1, 0, 0}, turned)(X - centre));
        return centre + Vector3{aside + setup.lateral_creepage * way, height(way), ahead} + arm;
      }

      /// Its velocity at the start.
      Vector3
      start_velocity(const Vector3 &X) const
      {
        const Vector3 rate = {
          setup.velocity * (1 + setup.creepage) / setup.radius, setup.velocity * setup.spin, 0};
        return Vector3{setup.lateral_creepage * setup.velocity, 0, setup.velocity} +
               cross(rate, X - Vector3{0, setup.radius, 0});
      }
    };

    struct Mean
    {
      double sum = 0, squares = 0;
      int    n = 0;
      void
      add(const double value)
      {
        sum += value;
        squares += value * value;
        ++n;
      }
      double
      mean() const
      {
        return sum / n;
      }
      double
      deviation() const
      {
        return std::sqrt(std::max(0., squares / n - mean() * mean()));
      }
    };

    void
    hold_bodies(Dynamics &scene, const RollingPairSetup &setup, const Path &path)
    {
      const LocalMesh &mesh = scene.solid.mesh;
      if (setup.strip)
        scene.fix(select(mesh, [](const Vector3 &) { return true; }), 0);
      else if (!setup.whole)
        scene.fix(select(mesh, plane(0, 0)), 0);
      for (int i = 0; i < 3; ++i)
        scene.fix(select(mesh, [&](const Vector3 &X) { return X[1] < 1e-9 - setup.depth; }), i);
      const double inner = setup.radius - setup.depth;
      for (unsigned int n = 0; n < mesh.n_nodes(); ++n)
        if (mesh.node_body[n] == Body::wheel)
          {
            const Vector3 X = place_of(mesh, n), v = path.start_velocity(X);
            for (int i = 0; i < 3; ++i)
              scene.solid.velocity[4 * n + i] = v[i];
            if (std::hypot(X[1] - setup.radius, X[2]) < inner + 1e-9)
              for (int i = 0; i < 3; ++i)
                scene.prescribe({n}, i, [=](const double time) { return path.place(X, time)[i] - X[i]; });
          }
    }
  } // namespace


  RollingPairRun
  roll(const RollingPairSetup &setup)
  {
    const double          wide = setup.wheel_cell_across > 0 ? setup.wheel_cell_across : setup.cell;
    const double          lng  = setup.wheel_cell_along > 0 ? setup.wheel_cell_along : setup.cell;
    const RunningSurfaces surfaces =
      wheel_on_plane(setup.radius, setup.crown, std::max(30e-3, 1.5 * setup.width));
    // both ends of the fine zone are multiples of the cells
    const auto fine = [&](const double cell) {
      return CellRange{
        -cell * std::ceil(13e-3 / cell), cell * std::ceil((setup.distance + 14e-3) / cell), cell};
    };
    const auto block_of = [&](const double h) { return along_rail(fine(h).begin, fine(h).end, h); };
    auto       depth    = fine_then_coarse(setup.cell, setup.fine_depth, setup.depth, 1.3);
    depth.back()        = setup.depth;

    Setup dynamics;
    dynamics.bulk_viscosity = setup.bulk_viscosity;
    Dynamics   scene(join(rail_block(across(setup, setup.cell), depth, block_of(setup.cell)),
                        wheel_block(surfaces, across(setup, wide), depth, block_of(lng))),
                   dynamics);
    const Path path{setup};
    hold_bodies(scene, setup, path);

    ContactSetup contact;
    contact.scale         = setup.scale;
    contact.cell_size     = setup.cell;
    contact.damping_ratio = setup.damping_ratio;
    contact.friction      = setup.friction;
    contact.symmetry      = {!setup.strip && !setup.whole, false};
    contact.half_window   = 13e-3;
    const LocalMesh &mesh = scene.solid.mesh;
    ContactPair      pair(
      scene,
      surfaces,
      make_surface(mesh,
                   Body::rail,
                   surfaces,
                   make_lattice(fine(setup.cell), fine_across(setup, setup.cell)),
                   MPI_COMM_SELF),
      make_surface(
        mesh, Body::wheel, surfaces, make_lattice(fine(lng), fine_across(setup, wide)), MPI_COMM_SELF),
      contact);
    pair.follow = [&](const double time) {
      const double way = setup.velocity * time;
      return std::array<double, 2>{way, way * setup.creepage};
    };

    RollingPairRun     run;
    const std::clock_t start = std::clock();
    Mean               normal, peak, lateral, longitudinal;
    const double       duration = setup.distance / setup.velocity;
    scene.step(true);
    while (scene.time() < duration)
      {
        scene.step(scene.time() + 1.5 * scene.time_step >= duration);
        if (setup.velocity * scene.time() < setup.distance - setup.averaged)
          continue;
        normal.add(pair.sums.force[1]);
        lateral.add(pair.sums.force[0]);
        longitudinal.add(pair.sums.force[2]);
        peak.add(pair.sums.largest_pressure);
      }
    run.seconds         = double(std::clock() - start) / CLOCKS_PER_SEC;
    run.steps           = scene.steps();
    run.elements        = mesh.cells.size();
    run.force           = {lateral.mean(), normal.mean(), longitudinal.mean()};
    run.noise           = normal.deviation() / normal.mean();
    run.peak            = peak.mean();
    run.peak_noise      = peak.deviation() / peak.mean();
    run.friction_energy = pair.friction_energy;
    run.damping_energy  = pair.damping_energy;
    const double kept   = pair.sums.stored_energy + pair.friction_energy + pair.damping_energy;
    run.energy_error    = std::abs(pair.work + kept) / kept;
    run.patch           = pair.patch();
    for (double &z : run.patch.along)
      z -= setup.velocity * (scene.time() - scene.time_step);
    return run;
  }
} // namespace scenes
