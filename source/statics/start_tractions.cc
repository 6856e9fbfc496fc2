#include <wheelrail/halfspace/tangential.h>
#include <wheelrail/planes/rigid_slip.h>
#include <wheelrail/statics/start_tractions.h>

#include <algorithm>
#include <cmath>

namespace wheelrail
{
  namespace
  {
    /// The loaded part of the lattice with one line around it, as a half-space grid: x along the track
    /// relative to the axle's lowest line, y = s, rail as body 1. Every node has `parts` x `parts` elements,
    /// an odd number: with one element a node, the creepage on 2 mm cells comes out 6 % too small. Sixty
    /// elements over the shorter extent are enough for any patch.
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
      loaded.n_i     = std::min<int>(lattice.n_along - 1, i1 + 1) - loaded.first_i + 1;
      loaded.n_j     = std::min<int>(lattice.n_lateral - 1, j1 + 1) - loaded.first_j + 1;
      const double extent =
        std::min(loaded.n_i * lattice.spacing_along, loaded.n_j * lattice.spacing_lateral);
      const double largest_element = std::max(0.35e-3, extent / 60);
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

    /// Squares of the nodes' pressures of the grid. Where a line of loaded nodes along the track or across it
    /// ends, the next node gets what a straight line through the last two has there: below zero, so that the
    /// patch ends between both, where its pressure does.
    class SquaredPressures
    {
    public:
      SquaredPressures(const Contact &contact, const LoadedGrid &loaded)
        : n_i_(loaded.n_i)
        , n_j_(loaded.n_j)
        , square_(std::size_t(n_i_) * n_j_, 0.)
      {
        for (int i = 0; i < n_i_; ++i)
          for (int j = 0; j < n_j_; ++j)
            square_[i + std::size_t(n_i_) * j] =
              std::pow(contact.nodes()[loaded.node(contact.lattice(), i, j)].pressure, 2);
        const std::vector<double> inside = square_;
        const auto                at     = [&](const int i, const int j) {
          return i >= 0 && j >= 0 && i < n_i_ && j < n_j_ ? inside[i + std::size_t(n_i_) * j] : 0;
        };
        for (int i = 0; i < n_i_; ++i)
          for (int j = 0; j < n_j_; ++j)
            if (at(i, j) == 0)
              {
                double sum = 0;
                int    n   = 0;
                for (int a = -1; a <= 1; ++a)
                  for (int b = -1; b <= 1; ++b)
                    if ((a != 0 || b != 0) && at(i + a, j + b) > 0)
                      {
                        sum += std::min(0., 2 * at(i + a, j + b) - at(i + 2 * a, j + 2 * b));
                        ++n;
                      }
                if (n > 0)
                  square_[i + std::size_t(n_i_) * j] = sum / n;
              }
      }

      double
      operator()(const int i, const int j) const
      {
        return i >= 0 && j >= 0 && i < n_i_ && j < n_j_ ? square_[i + std::size_t(n_i_) * j] : 0;
      }

    private:
      int                 n_i_, n_j_;
      std::vector<double> square_;
    };

    /// Pressures of the elements [Pa]: p^2, which falls to the edge of a patch as a straight line, is
    /// bilinear between the nodes, and the elements of each node have its pressure in the mean.
    std::vector<double>
    element_pressures(const Contact &contact, const LoadedGrid &loaded)
    {
      const SquaredPressures square(contact, loaded);
      std::vector<double>    pressure(loaded.grid.size(), 0.);
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
                  const double q = (1 - u) * ((1 - v) * square(i, j) + v * square(i, l)) +
                                   u * ((1 - v) * square(k, j) + v * square(k, l));
                  sum += pressure[loaded.element(i, j, a, b)] = std::sqrt(std::max(0., q));
                }
            const double scale =
              sum > 0 ? std::sqrt(std::max(0., square(i, j))) * loaded.parts * loaded.parts / sum : 0;
            for (int a = 0; a < loaded.parts; ++a)
              for (int b = 0; b < loaded.parts; ++b)
                pressure[loaded.element(i, j, a, b)] *= scale;
          }
      return pressure;
    }

    /// Pressures in the middle of the step of one element that steady rolling is found by: the mean of those
    /// of an element and of the one behind it. Tractions are those of the ends of such steps; with pressures
    /// of the same instant what sticks would begin half an element ahead of the patch, and the contact would
    /// be too stiff by as much (doc/theory/accuracy.md). The half that no element ahead takes stays, so that
    /// the sum does.
    std::vector<double>
    in_midst_of_step(const HalfspaceGrid &grid, const std::vector<double> &pressure)
    {
      std::vector<double> mean(grid.size(), 0.);
      for (int e = 0; e < grid.size(); ++e)
        {
          mean[e] += 0.5 * pressure[e];
          mean[e % grid.mx + 1 < grid.mx && pressure[e + 1] > 0 ? e + 1 : e] += 0.5 * pressure[e];
        }
      return mean;
    }

    /// Tractions at the places of the elements, of those found half an element behind: the mean of an element
    /// and of the one ahead. Where both slide they have what friction allows there.
    VectorField
    at_elements(const HalfspaceGrid       &grid,
                const std::vector<double> &pressure,
                const HalfspaceSolution   &behind)
    {
      VectorField traction{behind.traction_x, behind.traction_y};
      for (int e = 0; e < grid.size(); ++e)
        {
          if (behind.state[e] == HalfspaceSolution::exterior)
            continue;
          const int  ahead = e % grid.mx + 1 < grid.mx ? e + 1 : e;
          const bool first = ahead == e || behind.state[ahead] == HalfspaceSolution::exterior;
          double     x     = 0.5 * (behind.traction_x[e] + (first ? 0 : behind.traction_x[ahead])),
                 y         = 0.5 * (behind.traction_y[e] + (first ? 0 : behind.traction_y[ahead]));
          if (behind.state[e] == HalfspaceSolution::slip &&
              (first || behind.state[ahead] == HalfspaceSolution::slip))
            {
              const double size  = std::hypot(x, y);
              const double scale = size > 0 ? behind.friction[e] * pressure[e] / size : 0;
              x *= scale;
              y *= scale;
            }
          traction[0][e] = x;
          traction[1][e] = y;
        }
      return traction;
    }

    /// Inclination of the wheel's surface to the horizontal at s.
    double
    inclination(const RunningSurfaces &surfaces, const double s)
    {
      return surfaces.frame.angle + std::atan(surfaces.outline.at(s).slope);
    }

    /// The wheel's surface at s, in the plane across the track through the first contact point.
    WheelPlace
    wheel_place(const RunningSurfaces &surfaces, const double s)
    {
      const double  tangent = inclination(surfaces, s);
      const Vector3 axis    = surfaces.pose().axis();
      const double  sine    = std::sin(tangent) * axis[0] - std::cos(tangent) * axis[1];
      return {0, tangent, std::asin(sine), {}, surfaces.rolling(s, 0)};
    }

    /// When the wheel turns without creepage: a larger local radius runs backwards, ahead of the axle the
    /// wheel's surface still descends, which slides it along its inclination, and a wheel with yaw slides
    /// aside. The steel of a surface stretched by e passes a place that stands still with (1 + e) of its
    /// speed.
    void
    set_slip(const RunningSurfaces &surfaces, const StartMotion &start, HalfspaceProblem &problem)
    {
      WheelMotion motion;
      motion.forward_radius   = surfaces.forward_radius;
      motion.lateral_creepage = start.lateral_creepage;
      for (int j = 0; j < problem.grid.my; ++j)
        {
          const RowSlip slip = row_slip(wheel_place(surfaces, problem.grid.y(j)), motion, 0);
          for (int i = 0; i < problem.grid.mx; ++i)
            {
              problem.rigid_slip_x.push_back(slip.along + start.stretch);
              problem.rigid_slip_y.push_back(slip.lateral_at(problem.grid.x(i)));
            }
        }
    }

    /// The half-space problem of one contact; force or creepage are still to be given.
    struct StartProblem
    {
      LoadedGrid          loaded;
      HalfspaceProblem    problem;
      std::vector<double> pressure; ///< of the elements [Pa]; the problem has those in the middle of its step

      StartProblem(const Contact &contact, const HalfspaceSteels &bodies, const StartMotion &motion)
        : loaded(loaded_grid(contact))
        , problem(wheel_on_rail(bodies, contact.law().friction, motion.velocity))
      {
        problem.grid = loaded.grid;
        // the static search asks for tractions again until they stay within 1e-5
        problem.coupling_tolerance = 1e-5;
        if (loaded.grid.size() == 0)
          return;
        problem.pressure = element_pressures(contact, loaded);
        for (int j = 0; j < loaded.grid.my; ++j)
          for (int i = 0; i < loaded.grid.mx; ++i)
            problem.pressure[i + std::size_t(loaded.grid.mx) * j] *=
              area_ratio(contact, i / loaded.parts, j / loaded.parts);
        pressure         = problem.pressure;
        problem.pressure = in_midst_of_step(loaded.grid, pressure);
        set_slip(contact.surfaces(), motion, problem);
      }

      /// Nodes of inclined facets have more area than their elements.
      double
      area_ratio(const Contact &contact, const int i, const int j) const
      {
        return contact.rail().area[loaded.node(contact.lattice(), i, j)] /
               (loaded.grid.element_area() * loaded.parts * loaded.parts);
      }

      bool
      empty(const Contact &contact) const
      {
        return loaded.grid.size() == 0 || contact.law().friction.at_rest == 0;
      }
    };

    /// Tractions of the elements as means over the nodes.
    StartTractions
    nodal_tractions(const Contact &contact, const StartProblem &start, const HalfspaceSolution &solution)
    {
      const LoadedGrid &loaded = start.loaded;
      const int         parts  = loaded.parts;
      StartTractions    result;
      result.creepage  = solution.xi;
      result.force     = -solution.fx;
      result.converged = solution.converged();
      result.traction.assign(contact.nodes().size(), {0, 0, 0});
      const VectorField traction = at_elements(loaded.grid, start.pressure, solution);
      for (int i = 0; i < loaded.n_i; ++i)
        for (int j = 0; j < loaded.n_j; ++j)
          {
            double along = 0, lateral = 0;
            for (int a = 0; a < parts; ++a)
              for (int b = 0; b < parts; ++b)
                {
                  const std::size_t e = loaded.element(i, j, a, b);
                  along += traction[0][e] / (parts * parts);
                  lateral += traction[1][e] / (parts * parts);
                }
            const double angle = inclination(contact.surfaces(), loaded.grid.y(parts * j + (parts - 1) / 2));
            const double ratio = start.area_ratio(contact, i, j);
            result.traction[loaded.node(contact.lattice(), i, j)] = {
              lateral / ratio * std::cos(angle), lateral / ratio * std::sin(angle), along / ratio};
          }
      return result;
    }

    StartTractions
    without_tractions(const Contact &contact, const double creepage)
    {
      StartTractions result;
      result.creepage = creepage;
      result.traction.assign(contact.nodes().size(), {0, 0, 0});
      return result;
    }

    HalfspaceSolution
    solve_with_force(HalfspaceProblem &problem, const double force)
    {
      problem.longitudinal_force_given = true;
      problem.fx                       = -force;
      return solve_rolling(problem);
    }

    /// The solution with the largest force up to the one wanted that friction falling with the slip
    /// carries, to one per cent of the bound at rest: bisection from the force that it carries at any speed.
    HalfspaceSolution
    solve_with_falling_friction(HalfspaceProblem &problem, const double force, const double carried)
    {
      HalfspaceSolution best = solve_with_force(problem, force);
      if (best.within_friction && best.tangential_converged)
        return best;
      double low = std::copysign(carried, force), high = force;
      best = solve_with_force(problem, low);
      while (std::abs(high - low) > 0.01 * std::abs(force))
        {
          const double      middle = 0.5 * (low + high);
          HalfspaceSolution trial  = solve_with_force(problem, middle);
          if (trial.within_friction && trial.tangential_converged)
            {
              low  = middle;
              best = std::move(trial);
            }
          else
            high = middle;
        }
      return best;
    }
  } // namespace


  StartTractions
  start_tractions_at_creepage(const Contact         &contact,
                              const double           creepage,
                              const HalfspaceSteels &bodies,
                              const StartMotion     &motion)
  {
    StartProblem start(contact, bodies, motion);
    if (start.empty(contact))
      return without_tractions(contact, creepage);
    start.problem.xi = creepage;
    return nodal_tractions(contact, start, solve_rolling(start.problem));
  }


  StartTractions
  start_tractions(const Contact         &contact,
                  const double           longitudinal_force,
                  const HalfspaceSteels &bodies,
                  const StartMotion     &motion)
  {
    // the last two per cent below full slip cost any creepage; a torque beyond them spins the wheel up
    constexpr double   full_slip = 0.98;
    const FrictionLaw &friction  = contact.law().friction;
    double             load      = 0;
    for (std::size_t k = 0; k < contact.nodes().size(); ++k)
      load += contact.nodes()[k].pressure * contact.rail().area[k];
    const double   bound = full_slip * friction.at_rest * load;
    const double   force = std::clamp(longitudinal_force, -bound, bound);
    StartProblem   start(contact, bodies, motion);
    StartTractions result;
    if (start.empty(contact))
      result = without_tractions(contact, 0);
    else if (friction.steepest_fall() > 0)
      result = nodal_tractions(
        contact,
        start,
        solve_with_falling_friction(
          start.problem, force, std::min(std::abs(force), full_slip * friction.at_speed * load)));
    else
      result = nodal_tractions(contact, start, solve_with_force(start.problem, force));
    result.saturated = std::abs(result.force - longitudinal_force) > 0.01 * std::abs(longitudinal_force) + 1;
    return result;
  }
} // namespace wheelrail
