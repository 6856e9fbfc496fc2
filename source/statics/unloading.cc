#include <wheelrail/base/errors.h>
#include <wheelrail/mesh/discretization.h>
#include <wheelrail/statics/static_system.h>
#include <wheelrail/statics/unloading.h>
#include <wheelrail/wheelset/axle.h>

#include <string>

// Residual stresses: equilibrium without loads (doc/manual/material.md, Residual stress: the loads taken
// off).

namespace wheelrail
{
  namespace
  {
    /// Forces of the elements in the present position, one step from the history `flow`, on what is free.
    NodeVector
    out_of_balance(Solid &solid, const SavedPlasticState &flow, const StaticSystem &system)
    {
      flow.restore(solid.blocks);
      AlignedVector<double> force = element_forces_at_rest(solid);
      system.parts().add_forces(force);
      return system.right_hand_side(force);
    }
  } // namespace


  UnloadedBodies
  unload(const Discretization &discretization, Solid &solid, const SceneParts &parts, const Axle &axle)
  {
    // of the first residual; `of_step` of each linear solution: modified Newton with the elastic stiffness
    // takes few steps where little yields in reverse
    constexpr double       enough = 1e-5, of_step = 1e-3;
    constexpr unsigned int most_steps = 40;
    const WheelAxes        axes(axle);
    const KeptState        loaded(solid);
    // positions in the axes that turn with the wheel: its rotation is no load
    axes.to_wheel(solid);
    StaticSystem system(discretization, solid, parts);
    // no contact: bore and foot hold the bodies
    system.set_springs({});
    unsigned int cg_steps = 0;
    double       first    = 0;
    for (unsigned int steps = 0;; ++steps)
      {
        const NodeVector force = out_of_balance(solid, loaded.flow(), system);
        const double     norm  = force.l2_norm();
        // with nothing out of balance at first there is nothing to do
        if (steps == 0)
          first = norm;
        // over the forces that the taken-off loads leave at first
        const double left = first > 0 ? norm / first : 0;
        // equilibrium that the plastic strains alone keep up: contact, weight and inertia are off
        // (doc/manual/material.md, Residual stress)
        if (left <= enough)
          {
            axes.to_track(solid);
            return {solid.displacement, SavedPlasticState(solid.blocks), steps, cg_steps, left};
          }
        if (steps == most_steps || !(left < 10))
          throw RunError("the unloading did not converge: after " + std::to_string(steps) + " steps " +
                         std::to_string(100 * left) +
                         " % of the forces are left, and residual stresses stay unknown");
        NodeVector step = system.zero();
        // Newton's step with the elastic stiffness; steel that yields in reverse makes it slower, not wrong
        cg_steps += system.solve_held(force, of_step, step);
        system.add_to_nodes(step, 0, solid.displacement);
      }
  }


  WhileUnloaded::WhileUnloaded(Solid &solid, const UnloadedBodies &bodies)
    : loaded_(solid)
  {
    solid.displacement = bodies.displacement;
    bodies.flow.restore(solid.blocks);
  }
} // namespace wheelrail
