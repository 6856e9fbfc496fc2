#include <wheelrail/base/errors.h>
#include <wheelrail/solid/law_scope.h>
#include <wheelrail/statics/static_progress.h>
#include <wheelrail/statics/static_search.h>
#include <wheelrail/statics/static_start.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <utility>
#include <vector>

// Static start (doc/theory/rolling.md): 1. pressed rigidly by 0.55 of the approach; 2. Newton's steps with
// search, shear tractions set anew on the way, until no node has more than 2e-6 of the wheel load; 3. flow of
// bodies that yield, tractions for the pressures of the yielded patch; 4. tractions put into the contact.
// Flow of one step from rest: its potential is convex, and a quasi-Newton method of limited memory (Nocedal
// 1980) over the elastic preconditioner finds the minimum without the tangent of the flow
// (doc/manual/material.md, A wheel that rolls over a yielding rail).

namespace wheelrail
{
  namespace
  {
    struct StaticFlow
    {
      unsigned int  steps = 0;
      StaticBalance balance;       ///< in the position found
      bool          stuck = false; ///< far from the balance the steps led nowhere
    };

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

    /// Goes on from the equilibrium of elastic bodies to about that of bodies that flow: until no nodal force
    /// out of balance exceeds `tolerance` times the wheel load and the vertical balance holds to ten times
    /// that, for `most_steps` steps, or until steps lead nowhere (StaticProgress).
    ///
    /// The flow is that of one step from rest to the position (Hencky's deformation theory with linear
    /// hardening), for which the forces have a convex potential. Its minimum is found by the quasi-Newton
    /// method of limited memory (Nocedal 1980) over the preconditioner of the elastic system: flow lowers the
    /// shear modulus to a tenth at most with usual steels, and this is left to the memory. The history of the
    /// elements is that of the position found. Collective.
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

    /// How far the linear system of a Newton step is solved: a step of a tenth leaves the next one half as
    /// much again to do, one of a thousandth is lost to tractions that change.
    constexpr double linear = 0.05;

    constexpr int most_steps = 90, most_rounds = 20; ///< of Newton; of tractions and pressures in turn

    constexpr double nearly =
      1e-4; ///< of the wheel load: less than what the passing of cells excites in a run

    [[noreturn]] void
    throw_stuck(const double residual, const double missing)
    {
      throw RunError(
        "the static start finds no equilibrium: over " + std::to_string(StaticProgress::patience) +
        " steps what is out of balance did not fall, with " + std::to_string(std::lround(std::abs(missing))) +
        " N of the wheel load missing and " + std::to_string(std::lround(residual)) +
        " N left at a node; bodies may be too soft for this load, or the contact too stiff: look "
        "at Young's modulus, Yield stress, Tangent modulus and Contact/Penalty scale");
    }

    /// Throws where another step would lead nowhere. `missing`: of the wheel load [N].
    void
    check_goes_on(const StaticBalance &balance, const double missing, const int step)
    {
      if (step == most_steps)
        throw RunError("the static start did not converge: after " + std::to_string(most_steps) + " steps " +
                       std::to_string(missing) +
                       " N of the wheel load are missing; lower Contact/Penalty scale or refine the mesh");
      if (balance.sums.nodes == 0)
        throw RunError(
          "the static start lost the contact between wheel and rail; lower Contact/Penalty scale or "
          "Mesh/Solution cell size");
    }

    /// Newton's steps of elastic bodies until no nodal force out of balance exceeds `tolerance` times the
    /// wheel load and the tractions no longer change. Counts the steps in the result, and says there when
    /// they ended close to the equilibrium only, or at the border of the lattice.
    StaticBalance
    elastic_equilibrium(StaticSearch &search,
                        const bool    frictionless,
                        const double  tolerance,
                        StaticResult &result)
    {
      // what may be out of balance at a node when tractions are renewed: the first ones ask for the stretch
      // of the tread under pressure alone, later ones only have to follow the pressures that bound them
      // All limits are shares of the wheel load: `balanced`, `nearby` of the largest nodal force, `loaded` of
      // the vertical force, `unchanged` of creepage and forces.
      constexpr double balanced = 1e-3, nearby = 0.05;
      // and of the wheel load: two patches that trade a tenth of it would trade their tractions for ever
      constexpr double loaded = 3e-3, unchanged = 1e-5;
      double           change = loaded;
      // tractions for pressures that are not those of the equilibrium may move these as much again, for ever
      // on unless each time less is allowed
      double         allowed = 1;
      int            rounds  = frictionless ? 0 : most_rounds; // of tractions, still to come
      StaticBalance  balance = search.balance();
      StaticProgress progress;
      for (int step = 0;; ++step)
        {
          const double residual = balance.largest() / result.wheel_load;
          const double missing  = result.wheel_load - balance.sums.force[1];
          // a patch that hangs over the lattice may come to rest without the load
          const bool still = residual < tolerance;
          // converged: 2e-6 of the wheel load at each node, 1e-5 of it vertically (doc/theory/rolling.md,
          // Static start, 7)
          const bool settled = still && std::abs(missing) < 5 * tolerance * result.wheel_load;
          const bool carried = residual < (rounds == most_rounds ? balanced : nearby * allowed) &&
                               std::abs(missing) < std::min(loaded * allowed, 2 * change) * result.wheel_load;
          if (settled || (rounds > 0 && (carried || still)))
            {
              // tractions anew for the present pressures; from then on they are given loads (6)
              change             = rounds > 0 ? search.renew_tractions() : 0;
              const bool changed = change > unchanged;
              if (settled && !changed)
                return balance;
              --rounds;
              allowed *= 0.5;
              // each round allows half as much out of balance as the one before
              result.tractions_settled = !changed || rounds > 0;
              balance                  = search.balance();
              progress                 = StaticProgress();
            }
          const bool close = residual < nearly && std::abs(missing) < 10 * nearly * result.wheel_load;
          // [N]; the vertical balance counts as one more force
          const double norm  = std::hypot(balance.residual.l2_norm(), missing);
          const bool   stuck = progress.stuck(norm);
          // a patch that presses on the edge of the lattice for so long, or gets stuck there, finds no
          // equilibrium there
          const bool pressed_out = (step >= 20 || stuck) && balance.sums.at_border && !close;
          if (pressed_out || ((step == most_steps || stuck) && close))
            {
              result.converged = false;
              result.at_border = pressed_out;
              return balance;
            }
          if (stuck)
            throw_stuck(residual * result.wheel_load, missing);
          check_goes_on(balance, missing, step);
          // Newton's step on the elastic stiffness and the springs of the nodes in contact, then its length
          // (doc/theory/rolling.md, Static start, 2 and 5)
          balance             = search.search_along(search.newton_step(balance, linear), balance);
          result.newton_steps = step + 1;
        }
    }

    /// From the elastic equilibrium to about that of bodies that flow, with tractions for its pressures:
    /// those of the higher elastic pressures would make the surface flow too far. What is left out of balance
    /// is smaller than what the first millimetres of rolling change.
    StaticBalance
    plastic_equilibrium(StaticSearch &search, const bool frictionless, StaticResult &result)
    {
      // looser ends leave smooth parts of the shape to the way that led there, which differs by round-off: at
      // 2e-4 the rail head's turn differs by a hundredth, and tractions for pressures of a state at 2e-3 by
      // one in force and by three in work of friction from one number of ranks to the next
      constexpr double enough = 2e-5;
      // First pass: flow under the tractions of the elastic equilibrium; second one: under those of the lower
      // and wider pressures.
      StaticFlow flow   = static_flow(search, enough, 60);
      result.flow_steps = flow.steps;
      if (!frictionless)
        search.renew_tractions();
      flow = static_flow(search, enough, 60);
      result.flow_steps += flow.steps;
      const double residual = flow.balance.largest();
      if (flow.stuck)
        throw_stuck(residual, result.wheel_load - flow.balance.sums.force[1]);
      if (!(residual < 10 * nearly * result.wheel_load))
        result.converged = false;
      return std::move(flow.balance);
    }
  } // namespace


  StaticResult
  static_start(const Discretization                   &discretization,
               Solid                                  &solid,
               Contact                                &contact,
               const SceneParts                       &parts,
               const StaticLoads                      &loads,
               const std::function<void(std::string)> &report)
  {
    report("static start: assembling the stiffness");
    // 1. Bodies pressed into each other rigidly
    StaticSearch  search(discretization, solid, contact, parts, loads);
    const bool    without_friction = contact.law().friction.frictionless();
    StaticResult  result;
    StaticBalance balance;
    result.wheel_load = search.wheel_load();
    {
      // 2. Elastic equilibrium: the history stays that of the begin
      const FrozenScope rail(solid.blocks.rail), wheel(solid.blocks.wheel);
      balance = elastic_equilibrium(search, without_friction, 2e-6, result);
    }
    // flow raises the creepage, though the tractions of its lower pressures would need less
    result.creepage      = search.tractions.creepage;
    result.tread_stretch = search.stretch();
    if (without_friction)
      result.creepage = loads.rate_held ? loads.creepage : 0;
    // 3. Flow of bodies that yield, in one step from that history
    if (!result.at_border && (solid.blocks.rail.plastic() || solid.blocks.wheel.plastic()))
      {
        report("static start: plastic flow from the elastic equilibrium");
        balance = plastic_equilibrium(search, without_friction, result);
      }
    // 4. The contact remembers the tractions: the first step of the run begins with them
    search.set_tractions();
    result.residual         = balance.largest() / result.wheel_load;
    result.hub_displacement = search.hub_displacement;
    result.cg_steps         = search.cg_steps();
    result.contact_force    = balance.sums.force;
    result.at_border        = result.at_border || balance.sums.at_border;
    if (search.tractions.saturated)
      report("static start: the torque is beyond friction x wheel load; the wheel will spin up");
    if (!search.tractions.converged)
      report(
        "static start: the half-space solver did not reach its tolerance; the tractions of the start are "
        "less exact");
    else if (!result.tractions_settled)
      report("static start: pressures and tractions still changed each other after " +
             std::to_string(most_rounds) + " rounds; the first millimetres of rolling settle them");
    return result;
  }
} // namespace wheelrail
