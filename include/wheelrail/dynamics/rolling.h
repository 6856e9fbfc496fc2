#pragma once

#include <wheelrail/dynamics/rolling_contact.h>
#include <wheelrail/dynamics/time_loop.h>

#include <functional>

namespace wheelrail
{
  /// A wheel that rolls over a rail: the time loop with the parts of this scene. First come those that a
  /// static start has as well, such as supports and weights; then penalty contact presses and drags, and
  /// the axle carries and turns.
  class Rolling
  {
  public:
    /// The state in `solid` (displacement and velocity at the same instant) is the start. All must outlive
    /// the object. Collective.
    Rolling(Solid            &solid,
            Contact          &contact,
            const SceneParts &parts,
            Axle             &axle,
            const TimeScheme &scheme,
            MPI_Comm          communicator);

    /// Follows a changed mesh, or changed masses, see TimeLoop::prepare(). Collective.
    void
    prepare()
    {
      loop_.prepare();
    }

    /// Goes on on another mesh, see TimeLoop::change_mesh(). Collective.
    void
    change_mesh(const std::function<void()> &remake, const double middle)
    {
      loop_.change_mesh(remake, middle);
    }

    /// Lets the wheel with its axle turn faster by `change` [rad/s], as a rigid body; what that brings in is
    /// the supplied energy `rate_change_work`. Only where the axle's torque has a ramp. Collective.
    void
    turn_faster(double change);

    /// One time step. `with_energy` updates energy() too. Collective.
    void
    step(const bool with_energy)
    {
      loop_.step(with_energy);
    }

    double
    time() const
    {
      return loop_.time();
    }
    unsigned long
    steps() const
    {
      return loop_.steps();
    }
    const ContactSums &
    contact_sums() const
    {
      return contact_.sums();
    }
    const EnergyBalance &
    energy() const
    {
      return loop_.energy();
    }
    const TimeLoop::Timing &
    timing() const
    {
      return loop_.timing();
    }
    TimeLoop::State
    state() const
    {
      return loop_.state();
    }
    void
    set_state(const TimeLoop::State &state)
    {
      loop_.set_state(state);
    }

  private:
    Axle             &axle_;
    MPI_Comm          communicator_;
    RollingContact    contact_;
    AddedMassRotation added_mass_;
    TimeLoop          loop_;
    EnergyTerm       *rate_change_ = nullptr;
  };
} // namespace wheelrail
