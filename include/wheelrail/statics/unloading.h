#pragma once

#include <wheelrail/solid/part.h>
#include <wheelrail/solid/saved_plastic_state.h>
#include <wheelrail/solid/solid.h>
#include <wheelrail/wheelset/axle.h>

namespace wheelrail
{
  class Discretization;

  /// Both bodies with all loads taken off, without the solid that has their mesh.
  struct UnloadedBodies
  {
    AlignedVector<double> displacement; ///< u_res as in Solid [m]
    SavedPlasticState     flow;         ///< what flows while the loads go is in it
    unsigned int          steps    = 0; ///< of Newton's method
    unsigned int          cg_steps = 0;
    double residual = 0; ///< forces out of balance at the end over those at the begin (2-norms)
  };

  /// Takes all loads off both bodies, contact, weight and inertia, and finds the equilibrium that plastic
  /// strains alone keep up: residual stresses, and the displacements u_res that a passage has left. The parts
  /// of the scene carry the rail without their loads, the wheel's bore is held where the axle is now.
  ///
  /// Every position on the way is one step from the present history of the elements, so that steel that
  /// yields the other way round when the load goes does so; else plastic strains stay. The stiffness is the
  /// elastic one at rest, which the kernel's own forces correct (modified Newton); for the wheel in the axes
  /// that turn with it.
  ///
  /// The solid is needed to compute forces in, and left as it was. Throws RunError when it does not converge.
  /// Collective.
  UnloadedBodies
  unload(const Discretization &discretization, Solid &solid, const SceneParts &parts, const Axle &axle);

  /// As long as it lives a solid is in the state of its unloaded bodies, but for the velocities.
  class WhileUnloaded
  {
  public:
    WhileUnloaded(Solid &solid, const UnloadedBodies &bodies);

  private:
    KeptState loaded_;
  };
} // namespace wheelrail
