#pragma once

#include <wheelrail/solid/solid.h>

#include <vector>

namespace wheelrail
{
  // Central differences: displacements at full steps, velocities at half steps.

  /// How the force of a full step changes the velocities from one half step to the next:
  /// v becomes retain x v + gain x force / mass.
  struct VelocityUpdate
  {
    double duration = 0; ///< the step, or half of it from a start at a full step [s]
    double retain   = 1; ///< below 1 with mass damping
    double gain     = 0; ///< [s]
  };

  /// The velocity_update over `duration` [s] with the damping force -rate x mass x velocity [1/s], which
  /// belongs to the mean of the velocities of both half steps; without it, retain is exactly 1.
  VelocityUpdate
  make_velocity_update(double duration, double damping_rate = 0);

  /// One step of a rigid body's coordinate: its velocity is updated by the acceleration, its place follows.
  inline void
  advance(double               &place,
          double               &speed,
          const double          acceleration,
          const VelocityUpdate &velocity_update,
          const double          time_step)
  {
    speed = velocity_update.retain * speed + velocity_update.gain * acceleration;
    place += time_step * speed;
  }

  /// What a node needs in every step beside its state.
  struct NodeInertia
  {
    double inverse_mass = 0; ///< zero: the node does not move by forces (fixed, tied, hanging) [1/kg]
    double weight       = 0; ///< force against Y that acts in every step; on shared nodes, of one rank [N]
  };

  /// Inverse masses of all nodes, added mass included; hanging nodes have none.
  std::vector<NodeInertia>
  node_inertia(const Solid &solid);

  /// Sets solid.force to the weights: where the sum of the next step starts.
  void
  start_forces(Solid &solid, const std::vector<NodeInertia> &inertia);

  /// Mean of the velocities of both half steps around the full one, along which its forces work [m/s];
  /// solid.force must be final and the node not yet moved.
  inline Vector3
  mean_velocity(const Solid                    &solid,
                const std::vector<NodeInertia> &inertia,
                const unsigned int              node,
                const VelocityUpdate           &velocity_update)
  {
    const double *v = &solid.velocity[4 * node], *f = &solid.force[4 * node];
    const double  keep = 0.5 * (1 + velocity_update.retain),
                 gain  = 0.5 * velocity_update.gain * inertia[node].inverse_mass;
    return {keep * v[0] + gain * f[0], keep * v[1] + gain * f[1], keep * v[2] + gain * f[2]};
  }

  /// One step of central differences for all nodes of this rank in one pass over memory: velocities are
  /// updated, displacement += time_step x velocity, and solid.force becomes the weights again. Nodes without
  /// inverse mass stay where they are, hanging nodes too: see distribute().
  ///
  /// With `with_energy` it returns the kinetic energy at the full step of the nodes that this rank owns
  /// [J]: half the mass times the product of the velocities before and after, or of those before alone
  /// when the velocity_update is half a step. With it, central differences keep the energy of a linear body
  /// to round-off at any stable step (the mean of both squares would exceed it by up to the strain energy of
  /// the highest waves). Returns zero otherwise.
  double
  move_nodes(Solid                          &solid,
             const std::vector<NodeInertia> &inertia,
             const VelocityUpdate           &velocity_update,
             double                          time_step,
             bool                            with_energy);
} // namespace wheelrail
