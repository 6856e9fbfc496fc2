#include <wheelrail/solid/lanes.h>
#include <wheelrail/solid/motion.h>

// Central differences, velocities at half steps (doc/theory/rolling.md, Time stepping): second order, and
// stable up to omega dt = 2.

namespace wheelrail
{
  namespace
  {
    Four
    resting_force(const NodeInertia &inertia)
    {
      // -m g along Y: forces begin a step with the weight
      return Four{0, -inertia.weight, 0, 0};
    }

    /// `before`: whether the kinetic energy is that of the velocities before the velocity_update.
    template <bool with_energy>
    double
    pass(Solid                          &solid,
         const std::vector<NodeInertia> &inertia,
         const VelocityUpdate           &velocity_update,
         const double                    time_step,
         const bool                      before)
    {
      Four             *v       = reinterpret_cast<Four *>(solid.velocity.data());
      Four             *u       = reinterpret_cast<Four *>(solid.displacement.data());
      Four             *f       = reinterpret_cast<Four *>(solid.force.data());
      const std::size_t n_nodes = inertia.size();
      double            kinetic = 0;
      // velocities, displacements and the forces of the next step in one pass: each array is read from memory
      // once
      for (std::size_t n = 0; n < n_nodes; ++n)
        {
          const double inverse = inertia[n].inverse_mass;
          const Four   old     = v[n];
          // v(n+1/2) = v(n-1/2) + dt f(n)/m, u(n+1) = u(n) + dt v(n+1/2) (doc/theory/rolling.md, Time
          // stepping); tied nodes are placed by the part that holds them
          const Four now =
            (inverse > 0 ? velocity_update.retain : 1.) * old + (velocity_update.gain * inverse) * f[n];
          v[n] = now;
          u[n] += (inverse > 0 ? time_step : 0.) * now;
          f[n] = resting_force(inertia[n]);
          if constexpr (with_energy)
            if (inverse > 0 && solid.mesh.owns(n))
              {
                // v(n-1/2) m v(n+1/2)/2, which central differences conserve (doc/theory/rolling.md, Energy
                // balance); at the half step of the start both are those before
                const Four product = old * (before ? old : now);
                kinetic += 0.5 / inverse * (product[0] + product[1] + product[2]);
              }
        }
      return kinetic;
    }
  } // namespace


  // Mass-proportional damping of rate c [1/s], m v' = f - c m v, with v at n as the mean of both half steps:
  // implicit, without loss of stable step. A run has c = 0: such damping would brake the rolling wheel
  // (doc/theory/rolling.md, Axle, suspension, drive).
  VelocityUpdate
  make_velocity_update(const double duration, const double damping_rate)
  {
    // v(n+1/2) = ((1 - c dt/2) v(n-1/2) + dt f/m) / (1 + c dt/2) (doc/theory/rolling.md, Time stepping)
    const double damping = 0.5 * duration * damping_rate;
    return {duration, (1 - damping) / (1 + damping), duration / (1 + damping)};
  }


  std::vector<NodeInertia>
  node_inertia(const Solid &solid)
  {
    std::vector<NodeInertia> inertia(solid.mesh.n_nodes());
    for (std::size_t n = 0; n < inertia.size(); ++n)
      // hanging nodes have no mass: they stay without inverse mass and follow their parents
      if (solid.mass[n] > 0)
        // the added mass of the contact has inertia, no weight
        inertia[n].inverse_mass = 1 / (solid.mass[n] + solid.added_mass[n]);
    return inertia;
  }


  void
  start_forces(Solid &solid, const std::vector<NodeInertia> &inertia)
  {
    Four *f = reinterpret_cast<Four *>(solid.force.data());
    for (std::size_t n = 0; n < inertia.size(); ++n)
      f[n] = resting_force(inertia[n]);
  }


  double
  move_nodes(Solid                          &solid,
             const std::vector<NodeInertia> &inertia,
             const VelocityUpdate           &velocity_update,
             const double                    time_step,
             const bool                      with_energy)
  {
    return with_energy
             ? pass<true>(solid, inertia, velocity_update, time_step, velocity_update.duration < time_step)
             : pass<false>(solid, inertia, velocity_update, time_step, false);
  }
} // namespace wheelrail
