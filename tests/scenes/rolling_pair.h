#pragma once

// Two elastic bodies of the same steel in rolling contact: a piece of a wheel's rim, whose inner side
// follows a rigid motion, on a piece of rail.

#include "contact.h"

#include <memory>

namespace scenes
{
  struct RollingPairSetup
  {
    bool        strip  = true;  ///< plane strain, one cell wide; else half of a body symmetric about x = 0
    bool        whole  = false; ///< both halves
    double      radius = 0.46;  ///< of the wheel, along [m]
    double      crown  = 0;     ///< of its profile; 0: straight [m]
    double      cell   = 1e-3;  ///< [m]
    double      wheel_cell_across = 0; ///< of the wheel, 0: as the rail's [m]
    double      wheel_cell_along  = 0; ///< [m]
    double      depth = 40e-3, fine_depth = 6e-3, fine_across = 9e-3, width = 26e-3; ///< [m]
    double      velocity = 40;                                                       ///< [m/s]
    double      ramp = 12e-3, distance = 45e-3, averaged = 4e-3; ///< ways along the rail [m]
    double      descent  = 70e-6;                                ///< of the axle [m]
    double      creepage = 0, lateral_creepage = 0;              ///< (omega r - V)/V; lateral velocity over V
    double      spin  = 0;                                       ///< turn about the normal per way [rad/m]
    double      scale = 10, damping_ratio = 0.3, bulk_viscosity = 0.06;
    FrictionLaw friction;
  };

  struct RollingPairRun
  {
    Vector3 force{};                  ///< mean on the wheel [N], per cell width for a strip
    double  noise = 0;                ///< standard deviation of the normal over its mean
    double  peak = 0, peak_noise = 0; ///< mean largest nodal pressure [Pa], its standard deviation over it
    double  energy_error    = 0; ///< springs, friction and damping against the work of the contact forces
    double  friction_energy = 0, damping_energy = 0;
    wheelrail::PatchFields patch; ///< of the end, along counts from the axle
    double                 elements = 0, steps = 0, seconds = 0;
  };

  /// Rolls in from no load over `ramp`, then on to `distance`.
  RollingPairRun
  roll(const RollingPairSetup &setup);
} // namespace scenes
