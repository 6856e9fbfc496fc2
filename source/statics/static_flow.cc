#include <wheelrail/statics/static_flow.h>
#include <wheelrail/statics/static_progress.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <utility>
#include <vector>

// Flow of one step from rest: its potential is convex, and a quasi-Newton method of limited memory (Nocedal
// 1980) over the elastic preconditioner finds the minimum without the tangent of the flow
// (doc/manual/material.md, A wheel that rolls over a yielding rail).

namespace wheelrail
{
  namespace
  {
    /// A step made and the change of the forces out of balance that it brought, with the opposite sign.
    struct Secant
    {
      StaticStep step;
      NodeVector change;
      double     bore_change = 0;
      double     work        = 0; ///< of the change along the step; positive in a convex potential [J]
    };

    /// The step of the two loops of Nocedal (1980): the preconditioned one, made to fit the secants.
    StaticStep
    quasi_newton_step(StaticSearch &search, const StaticBalance &balance, const std::deque<Secant> &secants)
    {
      NodeVector          residual = balance.residual;
      double              bore     = balance.bore;
      std::vector<double> weight(secants.size());
      // y_k . s_k = `work` is positive for all secants kept, so that no quotient is singular
      for (std::size_t k = secants.size(); k-- > 0;)
        {
          const Secant &secant = secants[k];
          // first loop, newest secant first: w_k = s_k . q/(y_k . s_k), q -= w_k y_k; s the step, y the
          // change of minus the force (BFGS with limited memory)
          weight[k] = (residual * secant.step.increment + bore * secant.step.hub_displacement) / secant.work;
          residual.add(-weight[k], secant.change);
          bore -= weight[k] * secant.bore_change;
        }
      // the elastic multigrid cycle stands for the first inverse
      StaticStep step = search.preconditioned_step(residual, bore);
      for (std::size_t k = 0; k < secants.size(); ++k)
        {
          const Secant &secant = secants[k];
          const double  share =
            // second loop, oldest first: step += (w_k - y_k . step/(y_k . s_k)) s_k
            weight[k] -
            (secant.change * step.increment + secant.bore_change * step.hub_displacement) / secant.work;
          step.increment.add(share, secant.step.increment);
          step.hub_displacement += share * secant.step.hub_displacement;
        }
      return step;
    }

    /// Goes along the step until the slope of the potential is less than half of that at its begin. Scales
    /// the step to what was gone.
    StaticBalance
    go_along(StaticSearch &search, StaticStep &step, const StaticBalance &start)
    {
      // power = -(slope of the potential) along the step [J], positive at its begin in a convex potential.
      // The minimum is bracketed between `low` (power > 0) and `high` (power < 0); within the bracket a
      // secant that stays a tenth away from both ends.
      const double  first = search.power(start, step);
      double        at = 0, low = 0, power_low = first, high = 0, power_high = 0, next = 1;
      StaticBalance balance;
      for (int trial = 0; trial < 6; ++trial)
        {
          search.move(step, next - at);
          at                 = next;
          balance            = search.balance();
          const double value = search.power(balance, step);
          // Wolfe's condition on the slope
          if (std::abs(value) < 0.5 * first)
            break;
          if (value > 0)
            low = at, power_low = value;
          else
            high = at, power_high = value;
          if (high > 0)
            next = low + (high - low) * std::min(std::max(power_low / (power_low - power_high), 0.1), 0.9);
          else
            // beyond the end: where the slope would vanish on a straight line, 1.5 to 4 times as far
            next = at * std::min(4., std::max(1.5, first / std::max(first - value, 1e-9 * first)));
        }
      // s of the secant is what was gone, y the change that came of it
      step.increment *= at;
      step.hub_displacement *= at;
      return balance;
    }

    bool
    balanced(const StaticSearch &search, const StaticBalance &balance, const double tolerance)
    {
      // of nodes [N] and of the vertical contact force against the wheel load [N]
      const double load = search.wheel_load();
      return balance.largest() < tolerance * load &&
             // vertical balance to ten times the tolerance of a node
             std::abs(balance.sums.force[1] - load) < 10 * tolerance * load;
    }
  } // namespace


  StaticFlow
  static_flow(StaticSearch &search, const double tolerance, const unsigned int most_steps)
  {
    // secants, the newest; each holds two vectors of all nodes
    constexpr std::size_t memory = 10;
    constexpr double      near   = 1e-2; // of the wheel load: from here on slow steps are worth making
    StaticFlow            flow;
    std::deque<Secant>    secants;
    StaticProgress        progress;
    flow.balance = search.balance();
    while (flow.steps < most_steps && !balanced(search, flow.balance, tolerance))
      {
        // the vertical balance counts as one more force out of balance
        const double missing = search.wheel_load() - flow.balance.sums.force[1];
        flow.stuck           = progress.stuck(std::hypot(flow.balance.residual.l2_norm(), missing)) &&
                     !balanced(search, flow.balance, near);
        if (flow.stuck)
          break;
        // nodes that close have springs that the preconditioner should know
        if (flow.steps % 5 == 0)
          search.renew_springs();
        StaticStep    step = quasi_newton_step(search, flow.balance, secants);
        StaticBalance next = go_along(search, step, flow.balance);
        Secant        secant{step, flow.balance.residual, flow.balance.bore - next.bore};
        // y = residual before - residual after
        secant.change -= next.residual;
        secant.work = secant.change * step.increment + secant.bore_change * step.hub_displacement;
        // y . s > 0, or the inverse would not stay positive
        if (secant.work > 0)
          secants.push_back(std::move(secant));
        if (secants.size() > memory)
          secants.pop_front();
        flow.balance = std::move(next);
        ++flow.steps;
      }
    return flow;
  }
} // namespace wheelrail
