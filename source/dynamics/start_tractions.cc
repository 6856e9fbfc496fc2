#include <wheelrail/dynamics/start_tractions.h>
#include <wheelrail/halfspace/tangential.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace wheelrail
{
  namespace
  {
    /// The loaded part of the lattice with one line around it, as a half-space grid: x along the track
    /// relative to the axle's lowest line, y = s, rail as body 1. Every node has `parts` x `parts` elements,
    /// an odd number: with one element a node, the creepage on 2 mm cells comes out 6 % too small.
    struct LoadedGrid
    {
      int           first_i = 0, first_j = 0; ///< the first node
      int           n_i = 0, n_j = 0;         ///< nodes along and across
      int           parts = 1;
      HalfspaceGrid grid;

      std::size_t
      node(const Lattice &lattice, const int i, const int j) const
      {
        return lattice.index(first_i + i, first_j + j);
      }
      /// Element (a, b) of node (i, j).
      std::size_t
      element(const int i, const int j, const int a, const int b) const
      {
        return parts * i + a + std::size_t(grid.mx) * (parts * j + b);
      }
    };

    LoadedGrid
    loaded_grid(const Contact &contact)
    {
      constexpr double largest_element = 0.35e-3;
      const Lattice   &lattice         = contact.lattice();
      int              i0 = lattice.n_along, i1 = -1, j0 = lattice.n_lateral, j1 = -1;
      for (unsigned int i = 0; i < lattice.n_along; ++i)
        for (unsigned int j = 0; j < lattice.n_lateral; ++j)
          if (contact.nodes()[lattice.index(i, j)].pressure > 0)
            {
              i0 = std::min<int>(i0, i), i1 = std::max<int>(i1, i);
              j0 = std::min<int>(j0, j), j1 = std::max<int>(j1, j);
            }
      LoadedGrid loaded;
      if (i1 < i0)
        return loaded;
      loaded.first_i = std::max(0, i0 - 1);
      loaded.first_j = std::max(0, j0 - 1);
      loaded.n_i     = std::min<int>(lattice.n_along - 1, i1 + 1) - loaded.first_i + 1;
      loaded.n_j     = std::min<int>(lattice.n_lateral - 1, j1 + 1) - loaded.first_j + 1;
      while (std::max(lattice.spacing_along, lattice.spacing_lateral) > largest_element * loaded.parts)
        loaded.parts += 2;
      loaded.grid.mx      = loaded.n_i * loaded.parts;
      loaded.grid.my      = loaded.n_j * loaded.parts;
      loaded.grid.dx      = lattice.spacing_along / loaded.parts;
      loaded.grid.dy      = lattice.spacing_lateral / loaded.parts;
      const double before = 0.5 * (loaded.parts - 1); // elements before the node's own place
      loaded.grid.x0 =
        (lattice.first_station + loaded.first_i) * lattice.spacing_along - before * loaded.grid.dx;
      loaded.grid.y0 = lattice.s_begin + loaded.first_j * lattice.spacing_lateral - before * loaded.grid.dy;
      return loaded;
    }

    /// Pressures of the elements [Pa]: p^2, which falls to the edge of a patch as a straight line, is
    /// bilinear between the nodes, and the elements of each node have its pressure in the mean.
    std::vector<double>
    element_pressures(const Contact &contact, const LoadedGrid &loaded)
    {
      const auto nodal = [&](const int i, const int j) {
        const bool inside = i >= 0 && j >= 0 && i < loaded.n_i && j < loaded.n_j;
        return inside ? contact.nodes()[loaded.node(contact.lattice(), i, j)].pressure : 0;
      };
      std::vector<double> pressure(loaded.grid.size(), 0.);
      for (int i = 0; i < loaded.n_i; ++i)
        for (int j = 0; j < loaded.n_j; ++j)
          {
            double sum = 0;
            for (int a = 0; a < loaded.parts; ++a)
              for (int b = 0; b < loaded.parts; ++b)
                {
                  const int    da = 2 * a - loaded.parts + 1, db = 2 * b - loaded.parts + 1;
                  const double u = 0.5 * std::abs(da) / loaded.parts, v = 0.5 * std::abs(db) / loaded.parts;
                  const int    k = i + (da < 0 ? -1 : 1), l = j + (db < 0 ? -1 : 1);
                  const auto   square = [&](const int m, const int n) { return std::pow(nodal(m, n), 2); };
                  const double q      = (1 - u) * ((1 - v) * square(i, j) + v * square(i, l)) +
                                   u * ((1 - v) * square(k, j) + v * square(k, l));
                  sum += pressure[loaded.element(i, j, a, b)] = std::sqrt(q);
                }
            const double scale = sum > 0 ? nodal(i, j) * loaded.parts * loaded.parts / sum : 0;
            for (int a = 0; a < loaded.parts; ++a)
              for (int b = 0; b < loaded.parts; ++b)
                pressure[loaded.element(i, j, a, b)] *= scale;
          }
      return pressure;
    }

    /// Inclination of the wheel's surface to the horizontal at s.
    double
    inclination(const RunningSurfaces &surfaces, const double s)
    {
      return surfaces.frame.angle + std::atan(surfaces.wheel.at(s).slope);
    }

    /// Velocity of the rail's surface against the wheel's over V when the wheel turns without creepage:
    /// a larger local radius runs backwards, and ahead of the axle the wheel's surface still descends,
    /// which slides it along its inclination.
    VectorField
    rigid_slip(const RunningSurfaces &surfaces, const HalfspaceGrid &grid)
    {
      VectorField slip;
      for (int j = 0; j < grid.my; ++j)
        for (int i = 0; i < grid.mx; ++i)
          {
            const double s = grid.y(j);
            slip[0].push_back(surfaces.local_radius(s) / surfaces.rolling_radius - 1);
            slip[1].push_back(grid.x(i) / surfaces.rolling_radius * std::sin(inclination(surfaces, s)));
          }
      return slip;
    }

    HalfspaceBody
    half_space(const Elasticity &material)
    {
      return {material.shear_modulus(), material.poissons_ratio};
    }

    /// Solves with the force on the wheel given, or else the creepage.
    StartTractions
    solve(const Contact              &contact,
          const StartBodies          &bodies,
          const std::optional<double> force,
          const double                creepage)
    {
      StartTractions result;
      result.creepage = creepage;
      result.shear.assign(contact.nodes().size(), {0, 0, 0});
      const LoadedGrid     loaded = loaded_grid(contact);
      const HalfspaceGrid &grid   = loaded.grid;
      if (grid.size() == 0 || contact.law().friction.at_rest == 0)
        return result;

      InfluenceProducts products(grid);
      const SlipKernels kernels =
        slip_kernels(products,
                     halfspace_constants(half_space(bodies.rail), half_space(bodies.wheel)),
                     grid,
                     grid.dx,
                     true);
      TangentialTask task;
      task.kernels    = &kernels;
      task.grid       = grid;
      task.rigid_slip = rigid_slip(contact.surfaces(), grid);
      // nodes of inclined facets have more area than their elements
      const auto area_ratio = [&](const int i, const int j) {
        return contact.rail().area[loaded.node(contact.lattice(), i, j)] /
               (grid.element_area() * loaded.parts * loaded.parts);
      };
      task.bound = element_pressures(contact, loaded);
      for (int j = 0; j < grid.my; ++j)
        for (int i = 0; i < grid.mx; ++i)
          task.bound[i + std::size_t(grid.mx) * j] *=
            contact.law().friction.at_rest * area_ratio(i / loaded.parts, j / loaded.parts);
      if (force)
        {
          task.force_given[0] = true;
          task.force[0]       = -*force;
        }
      TangentialState state;
      state.creepage[0] = creepage;
      solve_tangential(products, task, state);

      result.creepage  = state.creepage[0];
      result.converged = state.converged;
      for (int i = 0; i < loaded.n_i; ++i)
        for (int j = 0; j < loaded.n_j; ++j)
          {
            double along = 0, lateral = 0; // means over the elements of the node
            for (int a = 0; a < loaded.parts; ++a)
              for (int b = 0; b < loaded.parts; ++b)
                {
                  const std::size_t e = loaded.element(i, j, a, b);
                  along += state.traction[0][e] / (loaded.parts * loaded.parts);
                  lateral += state.traction[1][e] / (loaded.parts * loaded.parts);
                  result.force -= state.traction[0][e] * grid.element_area();
                }
            const double angle =
              inclination(contact.surfaces(), grid.y(loaded.parts * j + (loaded.parts - 1) / 2));
            const double ratio                                 = area_ratio(i, j);
            result.shear[loaded.node(contact.lattice(), i, j)] = {
              lateral / ratio * std::cos(angle), lateral / ratio * std::sin(angle), along / ratio};
          }
      return result;
    }
  } // namespace


  StartTractions
  start_tractions_at_creepage(const Contact &contact, const double creepage, const StartBodies &bodies)
  {
    return solve(contact, bodies, {}, creepage);
  }


  StartTractions
  start_tractions(const Contact &contact, const double longitudinal_force, const StartBodies &bodies)
  {
    // the last two per cent below full slip cost any creepage; a torque beyond them spins the wheel up
    constexpr double full_slip = 0.98;
    double           bound     = 0;
    for (std::size_t k = 0; k < contact.nodes().size(); ++k)
      bound +=
        full_slip * contact.law().friction.at_rest * contact.nodes()[k].pressure * contact.rail().area[k];
    StartTractions result = solve(contact, bodies, std::clamp(longitudinal_force, -bound, bound), 0);
    result.saturated = std::abs(result.force - longitudinal_force) > 0.01 * std::abs(longitudinal_force) + 1;
    return result;
  }
} // namespace wheelrail
