#pragma once

#include <wheelrail/contact/contact.h>
#include <wheelrail/wheelset/axle.h>

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
} // namespace wheelrail
