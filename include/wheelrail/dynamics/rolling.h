#pragma once

#include <wheelrail/contact/contact.h>
#include <wheelrail/dynamics/time_loop.h>
#include <wheelrail/wheelset/axle.h>

#include <functional>
#include <vector>

namespace wheelrail
{
  /// The contact of the two running surfaces as a part of the time loop: its window follows the axle.
  ///
  /// The noted term `contact_scheme_energy` is what discrete contact has brought in since the start: spring
  /// energy, friction and damping less the work that the bodies did on the contact. In exact contact it is
  /// zero; nodes that open and close between two steps, and stick-slip changes, make it grow.
  class RollingContact : public Part
  {
  public:
    RollingContact(Contact &contact, const Axle &axle, MPI_Comm communicator)
      : contact_(contact)
      , axle_(axle)
      , communicator_(communicator)
    {
    }

    void
    enter(EnergyBalance &energies) override;
    void
    add_forces(const Instant &now, Solid &solid) override;
    void
    account(const Instant &now, const Solid &solid, const std::vector<NodeInertia> &inertia) override;

    /// Of the last step.
    const ContactSums &
    sums() const
    {
      return sums_;
    }

  private:
    Contact    &contact_;
    const Axle &axle_;
    MPI_Comm    communicator_;
    ContactSums sums_;
    bool        tells_  = false; ///< this rank adds what all ranks have alike
    EnergyTerm *stored_ = nullptr, *friction_ = nullptr, *damping_ = nullptr;
    EnergyTerm *gain_ = nullptr; ///< of the scheme
  };

  /// Turns the added mass of the wheel's running surface with the wheel: mass that moves on a circle needs a
  /// force towards its centre, and without one of its own it would pull at the rim.
  class AddedMassRotation : public Part
  {
  public:
    explicit AddedMassRotation(const Axle &axle)
      : axle_(axle)
    {
    }

    void
    prepare(const Solid &solid, std::vector<NodeInertia> &inertia) override;
    void
    enter(EnergyBalance &energies) override;
    void
    add_forces(const Instant &now, Solid &solid) override;
    void
    account(const Instant &now, const Solid &solid, const std::vector<NodeInertia> &inertia) override;

  private:
    const Axle               &axle_;
    std::vector<unsigned int> nodes_; ///< wheel nodes with added mass
    std::vector<Vector3>      force_; ///< on them in this step [N]
    EnergyTerm               *work_ = nullptr;
  };

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
