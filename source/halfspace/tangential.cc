#include <deal.II/lac/solver_control.h>
#include <deal.II/lac/solver_gmres.h>
#include <deal.II/lac/vector.h>

#include <wheelrail/base/interrupt.h>
#include <wheelrail/halfspace/friction_system.h>
#include <wheelrail/halfspace/tangential.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

// Tangential problem, |t| <= g = mu p, s = 0 inside the bound, t = -g s/|s| on it, as the equation t = P(t -
// s/b) with P the projection on |t| <= g: a semi-smooth Newton method on all elements at once, where TANG of
// Kalker (1990) changes sets of elements one by one.
// Checked: Carter's strip, creepage within 0.18 % with 400 elements; Cattaneo's shift, 0.2 %
// (doc/theory/halfspace.md, Verification).
//
// What ran into the contact within a step dq longer than an element: its slip is (u - u_edge)/(share dq),
// u_edge at the leading edge, share the part of dq since then (doc/theory/halfspace.md, Frame and signs), as
// in CONTACT.

namespace wheelrail
{
  namespace
  {
    using LinearMap = std::function<void(const std::vector<double> &, std::vector<double> &)>;
    using Vector    = dealii::Vector<double>;

    /// A map as deal.II's solvers call it.
    struct Applied
    {
      const LinearMap            &map;
      mutable std::vector<double> from, to;

      void
      vmult(Vector &result, const Vector &argument) const
      {
        leave_if_interrupted();
        from.assign(argument.begin(), argument.end());
        map(from, to);
        std::copy(to.begin(), to.end(), result.begin());
      }
    };

    /// Solves A x = b from x = 0 by GMRES with the right preconditioner M (both maps: result =
    /// map(argument)), without restart (Saad and Schultz 1986). Stops when |b - A x| <= tolerance |b| or
    /// after max_iterations products. Returns the number of products.
    int
    solve_gmres(const LinearMap           &A,
                const LinearMap           &M,
                const std::vector<double> &b,
                const double               tolerance,
                const int                  max_iterations,
                std::vector<double>       &x)
    {
      // A x = b by GMRES (Saad and Schultz 1986), preconditioned from the right so that the residual is that
      // of A itself and the tolerance means the same whatever the preconditioner
      const Vector load(b.begin(), b.end());
      Vector       solution(load.size());
      const double norm = load.l2_norm();
      x.assign(b.size(), 0.);
      // nothing to correct: the step is 0
      if (norm == 0)
        return 0;
      dealii::SolverControl control(max_iterations, tolerance * norm, false, false);
      // as many vectors as iterations: no restart
      dealii::SolverGMRES<Vector> solver(
        control, dealii::SolverGMRES<Vector>::AdditionalData(max_iterations + 2, true));
      try
        {
          solver.solve(Applied{A, {}, {}}, solution, load, Applied{M, {}, {}});
        }
      catch (const dealii::SolverControl::NoConvergence &) // Newton's next residual tells
        {
        }
      std::copy(solution.begin(), solution.end(), x.begin());
      return static_cast<int>(control.last_step());
    }

    // Newton steps that are exact to 1e-3 gain three digits each, enough where the sets of slip still change;
    // the limits lie far beyond what cases need: 25 products and 8 steps (doc/theory/halfspace.md)
    constexpr double krylov_tolerance   = 1e-3;
    constexpr int    max_krylov         = 200;
    constexpr int    max_inner_steps    = 12; ///< of one proximal point
    constexpr int    max_fallback_steps = 600;

    /// Newton steps from t; true when the tolerance is met within `max_steps`. Slip and residual are those of
    /// t. `from_nothing`: slip of the first t says nothing yet of which elements will slide.
    bool
    iterate(FrictionSystem      &system,
            const double         tolerance,
            const int            max_steps,
            const bool           from_nothing,
            std::vector<double> &t,
            std::vector<double> &slip,
            TangentialState     &state)
    {
      const LinearMap A = [&](const auto &v, auto &r) { system.multiply(v, r); };
      const LinearMap M = [&](const auto &v, auto &r) { system.precondition(v, r); };
      // P is not smooth where |q| = g; on either side of it the equations are, and each step takes the side
      // on which q lies (semi-smooth).
      std::vector<double> rhs, step;
      for (int steps = 0;; ++steps)
        {
          // 1. slip s = w + B t and residual t - P(t - s/b), P the projection on |t| <= mu p
          state.residual = system.residual(t, slip);
          // a singular step: the next method takes over
          if (!std::isfinite(state.residual))
            return false;
          // rms of t - P over the largest P, and missing force over n times the largest bound
          if (state.residual <= tolerance && system.force_error(t) <= tolerance)
            return true;
          if (steps == max_steps)
            return false;
          // 2. sets of stick and slip and the linear equations (doc/theory/halfspace.md, Tangential problem)
          system.linearise(t, slip, from_nothing && steps == 0, rhs);
          // 3. the whole step: a projection here would keep it from converging fast
          state.krylov_iterations += solve_gmres(A, M, rhs, krylov_tolerance, max_krylov, step);
          ++state.newton_steps;
          for (std::size_t k = 0; k < t.size(); ++k)
            t[k] += step[k];
        }
    }

    /// The slow method that does not fail: proximal points. Each solves the task with slip + c (t - t before)
    /// in place of the slip, which for a large c takes one step; c falls while that goes well.
    bool
    proximal_points(FrictionSystem       &system,
                    const TangentialTask &task,
                    std::vector<double>  &t,
                    std::vector<double>  &slip,
                    TangentialState      &state)
    {
      const int last = state.newton_steps + max_fallback_steps;
      // Rockafellar (1976): t is the limit of the solutions of s + c (t - t before) = 0 instead of s = 0; c
      // begins as large as an element's influence b on its own slip
      for (double c = task.kernels->diagonal; state.newton_steps < last;)
        {
          const std::vector<double> before = t;
          // the larger c is, the nearer the solution stays to t before
          system.hold(c, before);
          const bool good = iterate(system, 0.1 * task.tolerance, max_inner_steps, true, t, slip, state);
          system.hold(0, before);
          if (!good)
            t = before;
          else if (system.residual(t, slip) <= 1e-3)
            {
              std::vector<double> trial = t;
              if (iterate(system, task.tolerance, max_inner_steps, true, trial, slip, state))
                {
                  t = trial;
                  return true;
                }
            }
          // after a failure back beyond the last c that went well (8 x 0.3 > 1)
          c *= good ? 0.3 : 8;
        }
      return false;
    }

    /// Solves by Newton steps, and by proximal points where these fail.
    void
    solve_at_once(InfluenceProducts &products, const TangentialTask &task, TangentialState &state);

    /// One given force by interval halving of its creepage, where the force falls as the creepage rises.
    /// Where nearly all elements slide along it, to either side, Newton steps do not see how the force
    /// changes.
    void
    search_creepage(InfluenceProducts &products, const TangentialTask &task, TangentialState &state)
    {
      const int      d     = task.force_given[0] ? 0 : 1;
      TangentialTask given = task;
      given.force_given    = {{false, false}};
      // sum of mu p dA [N]; slip at which the stiffest element certainly slides
      double limit = 0, width = 0;
      for (std::size_t e = 0; e < task.bound.size(); ++e)
        if (task.bound[e] > 0)
          {
            limit += task.bound[e] * task.grid.element_area();
            width = std::max(width, std::abs(task.rigid_slip[d][e]) + task.kernels->diagonal * task.bound[e]);
          }
      TangentialState trial;
      trial.creepage     = {{std::isfinite(state.creepage[0]) ? state.creepage[0] : 0,
                         std::isfinite(state.creepage[1]) ? state.creepage[1] : 0}};
      const auto missing = [&](const double creepage) {
        // each try begins with the tractions of the one before
        trial.creepage[d] = creepage;
        solve_at_once(products, given, trial);
        state.newton_steps += trial.newton_steps;
        state.krylov_iterations += trial.krylov_iterations;
        double force = 0;
        for (const double t : trial.traction[d])
          force += t * task.grid.element_area();
        return task.force[d] - force; // rises with the creepage
      };
      // 1. Bracket, doubled until the force lies within; 2. halving
      double low = -width, high = width;
      for (int k = 0; k < 30 && missing(low) > 0; ++k)
        low *= 2;
      for (int k = 0; k < 30 && missing(high) < 0; ++k)
        high *= 2;
      for (int k = 0; k < 60; ++k)
        {
          const double middle = 0.5 * (low + high), more = missing(middle);
          // over the force that friction carries in all
          if (trial.converged && std::abs(more) <= task.tolerance * limit)
            {
              trial.newton_steps      = state.newton_steps;
              trial.krylov_iterations = state.krylov_iterations;
              state                   = trial;
              return;
            }
          (more < 0 ? low : high) = middle;
        }
    }
  } // namespace

  void
  solve_tangential(InfluenceProducts &products, const TangentialTask &task, TangentialState &state)
  {
    solve_at_once(products, task, state);
    if (!state.converged && task.force_given[0] != task.force_given[1])
      search_creepage(products, task, state);
  }


  namespace
  {
    void
    solve_at_once(InfluenceProducts &products, const TangentialTask &task, TangentialState &state)
    {
      FrictionSystem    system(products, task, state.creepage);
      const std::size_t n = system.elements.size();
      // unknowns: t_x, t_y of each element in contact, then the creepages whose force is given
      std::vector<double> cold(2 * n + system.forces.size(), 0.), slip, unused;
      for (std::size_t f = 0; f < system.forces.size(); ++f)
        cold[2 * n + f] = state.creepage[system.forces[f]];
      std::vector<double> t = cold;
      // guess: tractions of an earlier solution, cut to the bound of now
      bool warm = false;
      if (int(state.traction[0].size()) == task.grid.size())
        for (std::size_t e = 0; e < n; ++e)
          for (int d = 0; d < 2; ++d)
            {
              t[2 * e + d] = state.traction[d][system.elements[e]];
              warm         = warm || t[2 * e + d] != 0;
            }
      system.project(t);

      state.newton_steps = state.krylov_iterations = 0;
      state.converged =
        // tried in turn: from the guess, from no traction, proximal points
        warm && iterate(system, task.tolerance, std::min(15, task.max_steps), false, t, slip, state);
      if (!state.converged)
        state.converged = iterate(system, task.tolerance, task.max_steps, true, t = cold, slip, state);
      if (!state.converged)
        state.converged = proximal_points(system, task, t = cold, slip, state);

      state.residual = system.residual(t, slip);
      // the state of each element, and tractions within the bound, from the last t
      system.linearise(t, slip, false, unused);
      system.project(t);
      state.slipping.assign(task.grid.size(), 0);
      state.yield = task.yield;
      state.plastic.assign(task.yield.size(), 0.);
      if (!task.yield.empty())
        for (std::size_t e = 0; e < n; ++e)
          {
            const auto [yield, share]         = system.yielded(e, slip);
            state.yield[system.elements[e]]   = yield;
            state.plastic[system.elements[e]] = system.slipping[e] ? share : 0.;
          }
      for (int d = 0; d < 2; ++d)
        {
          state.traction[d].assign(task.grid.size(), 0.);
          state.slip[d].assign(task.grid.size(), 0.);
        }
      for (std::size_t e = 0; e < n; ++e)
        {
          state.slipping[system.elements[e]] = system.slipping[e];
          for (int d = 0; d < 2; ++d)
            {
              state.traction[d][system.elements[e]] = t[2 * e + d];
              state.slip[d][system.elements[e]]     = slip[2 * e + d];
            }
        }
      // creepages that were found, behind the tractions
      for (std::size_t f = 0; f < system.forces.size(); ++f)
        state.creepage[system.forces[f]] = t[2 * n + f];
    }
  } // namespace


  std::vector<RunIn>
  elements_run_in(const HalfspaceProblem &problem, const double step, const std::vector<double> &pressure)
  {
    const HalfspaceGrid &grid = problem.grid;
    // a step of one element at most: every particle in contact was in contact, or at the edge, a step before
    std::vector<RunIn> found;
    if (problem.motion == HalfspaceMotion::shift || problem.simplified || step < 1.001 * grid.dx)
      return found;
    for (int j = 0; j < grid.my; ++j)
      for (int i = grid.mx - 1, edge = -1; i >= 0; --i)
        {
          const int e = i + grid.mx * j;
          // from the leading edge on, against x
          if (!(pressure[e] > 0))
            edge = e;
          else if (edge >= 0 && i + 2 < grid.mx && (edge - e) * grid.dx < 0.9999 * step)
            found.push_back({e, edge, (edge - e) * grid.dx / step});
        }
    return found;
  }
} // namespace wheelrail
