#pragma once

#include <wheelrail/solid/solid.h>
#include <wheelrail/wheelset/axle.h>

namespace wheelrail
{
  class Forest;

  struct Unloading
  {
    unsigned int steps    = 0; ///< of Newton's method
    unsigned int cg_steps = 0;
    double       residual = 0; ///< forces out of balance at the end over those at the begin (2-norms)
  };

  /// Takes all loads off both bodies, contact, weight and inertia, and finds the equilibrium that plastic
  /// strains alone keep up: residual stresses, and the displacements u_res that a passage has left. Foot and
  /// ends of the rail are held where they are, the wheel's bore where the axle is now.
  ///
  /// Every position on the way is one step from the present history of the elements, so that steel that
  /// yields the other way round when the load goes does so; else plastic strains stay. The stiffness is the
  /// elastic one at rest, which the kernel's own forces correct (modified Newton); for the wheel in the axes
  /// that turn with it.
  ///
  /// Changes solid.displacement and the history of what flows; velocities stay. Throws RunError when it does
  /// not converge. Collective.
  Unloading
  unload(const Forest &forest, Solid &solid, const Axle &axle);
} // namespace wheelrail
