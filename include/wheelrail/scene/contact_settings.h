#pragma once

#include <wheelrail/material/friction.h>

#include <limits>

namespace wheelrail
{
  /// Friction and penalty, as in subsection Contact.
  struct ContactSettings
  {
    FrictionLaw friction = {0.5, FrictionKind::constant, 0.4, 0.05, 15}; ///< between wheel and rail
    double      left_friction =
      std::numeric_limits<double>::infinity(); ///< at rest, of the left rail; infinite: as the other
    double penalty_scale   = 10;               ///< effective scale f: eps = f K / h
    double contact_damping = 0.3;              ///< fraction of critical
    bool   surface_filter  = true;             ///< corrects the surface response of the mesh
  };
} // namespace wheelrail
