#include <wheelrail/dynamics/rolling.h>

namespace wheelrail
{
  Rolling::Rolling(Solid            &solid,
                   Contact          &contact,
                   const SceneParts &parts,
                   Axle             &axle,
                   const TimeScheme &scheme,
                   MPI_Comm          communicator)
    : axle_(axle)
    , communicator_(communicator)
    , contact_(contact, axle, communicator)
    , added_mass_(axle)
    , loop_(solid, scheme, communicator)
  {
    for (const auto &part : parts)
      loop_.add(*part);
    loop_.add(contact_);
    loop_.add(added_mass_);
    loop_.add(axle);
    if (axle.data().torque_ramp > 0)
      rate_change_ = &loop_.energy().term("rate_change_work", EnergyKind::supplied);
    loop_.prepare();
  }


  void
  Rolling::turn_faster(const double change)
  {
    const double before = axle_.energy().kinetic;
    axle_.add_rate(change);
    double gain = loop_.add_spin(Body::wheel, axle_.centre(), change * axle_.axis());
    int    rank;
    MPI_Comm_rank(communicator_, &rank);
    if (rank == 0) // all ranks have the same axle
      gain += axle_.energy().kinetic - before;
    rate_change_->add_done(gain);
  }
} // namespace wheelrail
