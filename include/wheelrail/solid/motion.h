#pragma once

#include <wheelrail/solid/solid.h>

namespace wheelrail
{
  /// What a node needs in every step beside its state.
  struct NodeInertia
  {
    double inverse_mass = 0; ///< zero: the node does not move by forces (fixed, tied, hanging) [1/kg]
    double weight       = 0; ///< force against Y that acts in every step; on shared nodes, of one rank [N]
  };

  /// Sets solid.force to the weights: where the sum of the next step starts.
  void
  start_forces(Solid &solid, const std::vector<NodeInertia> &inertia);

  /// One step of central differences for all nodes of this rank in one pass over memory:
  /// velocity += kick x force / mass, displacement += time_step x velocity, and solid.force becomes the
  /// weights again. `kick` is the step, or half of it from a start at a full step [s]. Nodes without
  /// inverse mass stay where they are, hanging nodes too: see distribute().
  ///
  /// With `with_energy` it returns the kinetic energy at the full step of the nodes that this rank owns
  /// [J]: half the mass times the product of the velocities before and after, or of those before alone
  /// when `kick` is half a step. With it, central differences keep the energy of a linear body to
  /// round-off at any stable step. Returns zero otherwise.
  double
  move_nodes(Solid                          &solid,
             const std::vector<NodeInertia> &inertia,
             double                          kick,
             double                          time_step,
             bool                            with_energy);
} // namespace wheelrail
