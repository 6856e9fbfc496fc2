#include <wheelrail/dynamics/rolling.h>

namespace wheelrail
{
  Rolling::Rolling(Solid            &solid,
                   Contact          &contact,
                   const SceneParts &parts,
                   Axle             &axle,
                   const TimeScheme &scheme,
                   MPI_Comm          communicator)
    : contact_(contact, axle, communicator)
    , added_mass_(axle)
    , loop_(solid, scheme, communicator)
  {
    for (const auto &part : parts)
      loop_.add(*part);
    loop_.add(contact_);
    loop_.add(added_mass_);
    loop_.add(axle);
    loop_.prepare();
  }
} // namespace wheelrail
