#pragma once

#include <wheelrail/solid/part.h>

namespace wheelrail
{
  /// Square of the highest angular frequency of the free bodies, from below [1/s2]: the largest Ritz
  /// value of `steps` Lanczos steps (Lanczos 1950) on the lumped masses and the elements at rest. Within
  /// about one per cent after 40 steps. Element bounds are exact for endless meshes; nodes at free edges
  /// carry less mass for the stiffness they see and can go beyond them, most for Poisson's ratios near
  /// 0.5. Masses must be lumped. Collective.
  double
  highest_frequency(Solid &solid, MPI_Comm communicator, int steps = 40);

  /// Lowers solid.stable where the whole mesh swings faster than its stiffest element, for the damping
  /// ratio `bulk_viscosity` taken at the half step behind. Collective.
  void
  lower_stable_step(Solid &solid, double bulk_viscosity, MPI_Comm communicator);

  /// Lowers solid.stable for the stiffness of parts that are prepared for the solid: the squares of the
  /// highest angular frequencies of bodies and parts add up at most (Rayleigh). Collective.
  void
  lower_stable_step(Solid &solid, const SceneParts &parts);
} // namespace wheelrail
