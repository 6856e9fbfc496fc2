#include <wheelrail/halfspace/friction_field.h>
#include <wheelrail/halfspace/simplified.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

// Simplified theory, FASTSIM (Kalker 1982): u = L t at each point by itself, L the flexibilities [m/Pa], so
// that a row is one sweep from its leading edge. Forces are off by some ten per cent.

namespace wheelrail
{
  namespace
  {
    /// What the rows are swept with.
    struct Sweep
    {
      const HalfspaceProblem    &problem;
      const double               step;
      const std::vector<double> &pressure;
      const TangentialTask      &task;
      TangentialState           &state;
      std::vector<double>       &friction;

      /// Slip of an element whose traction was `trial` without a bound and is cut to the length `size`.
      std::array<double, 2>
      slip(const std::array<double, 2> &trial, const double size) const
      {
        const SimplifiedTheory &theory = *problem.simplified;
        // s = L (t - t_trial)/h with t = t_trial size/|t_trial|
        // negative: the traction cut back lets the element slide against it
        const double left = size / std::hypot(trial[0], trial[1]) - 1;
        return {{theory.along * trial[0] * left / step, theory.across * trial[1] * left / step}};
      }

      /// The coefficient of an element in row j, and whether it slips.
      double
      coefficient(const int                    j,
                  const double                 p,
                  const double                 ahead,
                  const std::array<double, 2> &trial,
                  bool                        &slips) const
      {
        const auto at = [&](const double velocity) {
          return friction_of_particle(
            problem, problem.friction_of_row(j).at(velocity), velocity, ahead, step);
        };
        // 1. Friction at rest bounds what sticks
        double high = at(0);
        slips       = std::hypot(trial[0], trial[1]) > high * p;
        if (!slips || !problem.friction_of_row(j).depends_on_speed())
          return high;
        // a smaller coefficient slips faster, which has a smaller one again: halving
        // 2. The largest coefficient that fits its own slip: mu = mu(V |s(mu)|)
        double low = 0;
        for (int k = 0; k < 50; ++k)
          {
            const double middle                                                   = 0.5 * (low + high);
            const auto   s                                                        = slip(trial, middle * p);
            (at(problem.velocity * std::hypot(s[0], s[1])) < middle ? high : low) = middle;
          }
        return 0.5 * (low + high);
      }

      /// The tractions at the creepages of the state; returns their forces [N].
      std::array<double, 2>
      operator()()
      {
        // doc/theory/halfspace.md has the signs: x ahead, tractions on body 1, s of body 1 against body 2
        const HalfspaceGrid &grid = task.grid;
        const double         L[2] = {problem.simplified->along, problem.simplified->across};
        const auto           n    = std::size_t(grid.size());
        state.slipping.assign(n, 0);
        for (int d = 0; d < 2; ++d)
          {
            state.traction[d].assign(n, 0.);
            state.slip[d].assign(n, 0.);
          }
        std::array<double, 2> force{{0, 0}};
        for (int j = 0; j < grid.my; ++j)
          {
            // unloaded material runs in with t = 0
            std::array<double, 2> t{{0, 0}}; // of the element ahead
            double                ahead = problem.friction_of_row(j).at(0);
            for (int i = grid.mx - 1; i >= 0; --i)
              {
                const auto e = std::size_t(i + grid.mx * j);
                if (pressure[e] <= 0)
                  {
                    t     = {{0, 0}};
                    ahead = problem.friction_of_row(j).at(0);
                    continue;
                  }
                for (int d = 0; d < 2; ++d)
                  // sticking: t = t_ahead - h w/L, w the rigid slip (Kalker 1982)
                  t[d] -= step * (task.rigid_slip[d][e] + state.creepage[d]) / L[d];
                bool slips  = false;
                ahead       = coefficient(j, pressure[e], ahead, t, slips);
                friction[e] = ahead;
                if (slips)
                  {
                    // sliding: |t| = mu p, in the direction of the traction without a bound
                    const double size = ahead * pressure[e], whole = std::hypot(t[0], t[1]);
                    const auto   s    = slip(t, size);
                    state.slipping[e] = 1;
                    for (int d = 0; d < 2; ++d)
                      {
                        // s = w + L (t - t ahead)/step
                        state.slip[d][e] = s[d];
                        t[d] *= size / whole;
                      }
                  }
                for (int d = 0; d < 2; ++d)
                  {
                    state.traction[d][e] = t[d];
                    force[d] += t[d] * grid.element_area();
                  }
              }
          }
        return force;
      }
    };
  } // namespace


  void
  solve_simplified(const HalfspaceProblem    &problem,
                   const double               step,
                   const std::vector<double> &pressure,
                   const TangentialTask      &task,
                   TangentialState           &state,
                   std::vector<double>       &friction)
  {
    Sweep sweep{problem, step, pressure, task, state, friction};
    // creepages beyond 4 width slide everywhere: the root lies between
    double limit = 0, width = 0;
    for (const double bound : task.bound)
      {
        limit += bound * task.grid.element_area();
        width = std::max(width, bound);
      }
    // a slip of mu p L/dq carries an element to its bound within one step
    width *= std::max(problem.simplified->along, problem.simplified->across) / step; // all elements slide
    // given creepages: one sweep is the solution
    std::array<double, 2> force = sweep();
    // a force falls as its creepage rises: halving, that along inside that across
    const auto search = [&](const int d, const auto &others) {
      double low = -4 * width, high = 4 * width;
      for (int k = 0; k < 60 && task.force_given[d]; ++k)
        {
          state.creepage[d] = 0.5 * (low + high);
          others();
          force                                   = sweep();
          (force[d] > task.force[d] ? low : high) = state.creepage[d];
        }
    };
    const auto none  = [] {};
    const auto along = [&] { search(0, none); };
    if (task.force_given[1])
      search(1, along);
    else
      along();
    // missing force over mu N
    state.residual = 0;
    for (int d = 0; d < 2; ++d)
      if (task.force_given[d] && limit > 0)
        state.residual = std::max(state.residual, std::abs(force[d] - task.force[d]) / limit);
    state.converged = state.residual <= task.tolerance;
  }
} // namespace wheelrail
