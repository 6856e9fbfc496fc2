#pragma once

#include <wheelrail/contact/contact.h>

namespace wheelrail
{
  /// Shear tractions and creepage that a run starts from.
  struct StartTractions
  {
    double               creepage  = 0;     ///< at the rolling radius of 2D-Geo, positive driving
    double               force     = 0;     ///< longitudinal force on the wheel that the tractions give [N]
    bool                 saturated = false; ///< the wanted force exceeds the friction bound
    std::vector<Vector3> shear;             ///< traction on the rail at every lattice node [Pa]
  };

  /// Kalker's linear creepage coefficient C11 for Poisson's ratio 0.3 and the ratio of the semi-axes
  /// along and across the rolling direction (Kalker 1990, table E.3, interpolated).
  double
  creepage_coefficient(double along_over_across);

  /// Steady shear tractions for a given longitudinal force [N, on the wheel] by Kalker's simplified
  /// theory (FASTSIM, 1982) on the pressures of `contact`: every lateral strip slides with its own
  /// rolling radius and, ahead of and behind the axle, sideways with the inclined surface of the
  /// turning wheel (together: creepage and spin), traction grows from the leading edge and is cut at the
  /// Coulomb bound. The creepage is found by bisection. A prediction to start from, not a result.
  StartTractions
  start_tractions(const Contact &contact, double longitudinal_force, double shear_modulus);

  /// The same with the creepage given instead of the force.
  StartTractions
  start_tractions_at_creepage(const Contact &contact, double creepage, double shear_modulus);
} // namespace wheelrail
