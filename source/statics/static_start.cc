#include <wheelrail/base/errors.h>
#include <wheelrail/solid/law_scope.h>
#include <wheelrail/statics/static_flow.h>
#include <wheelrail/statics/static_progress.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <utility>

// Static start (doc/theory/rolling.md): 1. pressed rigidly by 0.55 of the approach; 2. Newton's steps with
// search, shear tractions set anew on the way, until no node has more than 2e-6 of the wheel load; 3. flow of
// bodies that yield, tractions for the pressures of the yielded patch; 4. tractions put into the contact.

namespace wheelrail
{
  namespace
  {
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
