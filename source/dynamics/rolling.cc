#include <wheelrail/dynamics/rolling.h>

namespace wheelrail
{
  Rolling::Rolling(Solid            &solid,
                   Contact          &contact,
                   Axle             &axle,
                   const TimeScheme &scheme,
                   MPI_Comm          communicator)
    : supports_({Boundary::foot, Boundary::end}, communicator)
    , weight_(Body::wheel, axle.data().gravity)
    , contact_(contact, axle, communicator)
    , added_mass_(axle)
    , loop_(solid, scheme, communicator)
  {
    loop_.add(supports_);
    loop_.add(weight_);
    loop_.add(contact_);
    loop_.add(added_mass_);
    loop_.add(axle);
    loop_.prepare();
  }
} // namespace wheelrail
