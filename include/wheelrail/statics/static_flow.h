#pragma once

#include <wheelrail/statics/static_search.h>

namespace wheelrail
{
  struct StaticFlow
  {
    unsigned int  steps = 0;
    StaticBalance balance;       ///< in the position found
    bool          stuck = false; ///< far from the balance the steps led nowhere
  };

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
  static_flow(StaticSearch &search, double tolerance, unsigned int most_steps);
} // namespace wheelrail
