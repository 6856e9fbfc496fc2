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
    /// relative to the axle's lowest line, y = s, rail as body 1.
    struct LoadedGrid
    {
      int           first_i = 0, first_j = 0;
      HalfspaceGrid grid;

      std::size_t
      node(const Lattice &lattice, const int i, const int j) const
      {
        return lattice.index(first_i + i, first_j + j);
      }
    };

    LoadedGrid
    loaded_grid(const Contact &contact)
    {
      const Lattice &lattice = contact.lattice();
      int            i0 = lattice.n_along, i1 = -1, j0 = lattice.n_lateral, j1 = -1;
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
      loaded.grid.mx = std::min<int>(lattice.n_along - 1, i1 + 1) - loaded.first_i + 1;
      loaded.grid.my = std::min<int>(lattice.n_lateral - 1, j1 + 1) - loaded.first_j + 1;
      loaded.grid.dx = lattice.spacing_along;
      loaded.grid.dy = lattice.spacing_lateral;
      loaded.grid.x0 = (lattice.first_station + loaded.first_i) * lattice.spacing_along;
      loaded.grid.y0 = lattice.s_begin + loaded.first_j * lattice.spacing_lateral;
      return loaded;
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
      std::vector<double> area_ratio;
      for (int j = 0; j < grid.my; ++j)
        for (int i = 0; i < grid.mx; ++i)
          {
            const std::size_t k = loaded.node(contact.lattice(), i, j);
            area_ratio.push_back(contact.rail().area[k] / grid.element_area());
            task.bound.push_back(contact.law().friction.at_rest * contact.nodes()[k].pressure *
                                 area_ratio.back());
          }
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
      for (int j = 0; j < grid.my; ++j)
        {
          const double angle = inclination(contact.surfaces(), grid.y(j));
          for (int i = 0; i < grid.mx; ++i)
            {
              const int    e                                     = i + grid.mx * j;
              const double along                                 = state.traction[0][e] / area_ratio[e],
                           lateral                               = state.traction[1][e] / area_ratio[e];
              result.shear[loaded.node(contact.lattice(), i, j)] = {
                lateral * std::cos(angle), lateral * std::sin(angle), along};
              result.force -= state.traction[0][e] * grid.element_area();
            }
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
