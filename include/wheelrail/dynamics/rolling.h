#pragma once

#include <wheelrail/contact/contact.h>
#include <wheelrail/solid/motion.h>
#include <wheelrail/wheelset/axle.h>

namespace wheelrail
{
  /// The energy balance [J]. `residual` is what the parts fail to add up to since the start.
  struct EnergyBalance
  {
    double kinetic = 0, strain = 0, stabilisation = 0, contact = 0, potential = 0;      ///< states
    double plastic = 0, viscous = 0, friction = 0, contact_damping = 0, suspension = 0; ///< dissipated
    double torque_work = 0, hold_work = 0, support_work = 0;                            ///< supplied
    double residual = 0;
    double start    = 0; ///< total at the start
    double error    = 0; ///< |residual| over strain plus dissipated energy

    double
    dissipated() const
    {
      return plastic + viscous + friction + contact_damping + suspension;
    }
  };

  /// Explicit rolling: central differences for both bodies, penalty contact and the axle.
  ///
  /// Displacements are known at full steps, velocities at half steps. One step: internal forces,
  /// loads, contact, axle, then all free nodes.
  class Rolling
  {
  public:
    /// The state in `solid` (displacement and velocity at the same instant) is the start.
    Rolling(Solid   &solid,
            Contact &contact,
            Axle    &axle,
            double   time_step,
            double   bulk_viscosity,
            MPI_Comm communicator);

    /// One time step. `with_energy` updates energy() too. Collective.
    void
    step(bool with_energy);

    double
    time() const
    {
      return time_;
    }
    unsigned long
    steps() const
    {
      return steps_;
    }
    const ContactSums &
    contact_sums() const
    {
      return sums_;
    }
    const EnergyBalance &
    energy() const
    {
      return energy_;
    }
    /// What one step leaves to the next, beside bodies, contact and axle.
    struct State
    {
      double        time    = 0; ///< [s]
      unsigned long steps   = 0;
      double        viscous = 0, support_work = 0;     ///< of this rank [J]
      double        friction = 0, contact_damping = 0; ///< [J]
      bool          balance_started = false;
      double        energy_at_start = 0; ///< [J]
      double        energy_error    = 0; ///< of the last balance
    };
    State
    state() const;
    void
    set_state(const State &state);

    /// Seconds spent in elements, exchange, contact, and update since the start (this rank).
    struct Timing
    {
      double elements = 0, exchange = 0, contact = 0, update = 0;
    };
    const Timing &
    timing() const
    {
      return timing_;
    }

  private:
    void
    add_loads();
    double
    update_nodes(bool first, bool with_energy);
    void
    balance(double kinetic, const AxleEnergy &axle_before, double support_before);

    Solid                    &solid_;
    Contact                  &contact_;
    Axle                     &axle_;
    SharedSum                 sum_;
    double                    time_step_, bulk_viscosity_;
    MPI_Comm                  communicator_;
    std::vector<NodeInertia>  inertia_;       ///< inverse masses zero at nodes that are fixed, tied or hang
    std::vector<unsigned int> added_nodes_;   ///< wheel nodes with bipenalty mass
    std::vector<Vector3>      support_force_; ///< on them in this step [N]
    double                    time_  = 0;
    unsigned long             steps_ = 0;
    ContactSums               sums_;
    ElementEnergy             elements_; ///< of the last step that asked for it; viscous power always
    EnergyBalance             energy_;
    double                    support_work_ = 0; ///< of the force that turns the bipenalty mass, this rank
    double                    viscous_ = 0, friction_ = 0, contact_damping_ = 0;
    bool                      balance_started_ = false;
    Timing                    timing_;
  };
} // namespace wheelrail
