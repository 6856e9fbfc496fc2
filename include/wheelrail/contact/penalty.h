#pragma once

#include <wheelrail/contact/contact.h>

namespace wheelrail
{
  /// What makes a penalty stiff enough and keeps it stable with the step of the elements.
  struct Penalty
  {
    double stiffness  = 0; ///< eps, normal and tangential [N/m3]
    double damping    = 0; ///< [N s/m3]
    double added_mass = 0; ///< on the surface nodes of both bodies [kg/m2]
  };

  /// Penalty of the effective scale f: eps = f K / h, with the added ("bipenalty") mass that keeps the
  /// contact springs from shortening the step (Askes, Caramés-Saddler and Rodríguez-Ferran 2010).
  ///
  /// A spring eps between two masses m per area swings at sqrt(2 eps/m). With the damping ratio z, the
  /// damper taken at the half step behind, central differences are stable up to omega dt = 2 (sqrt(1 +
  /// z^2) - z), so m = 2 eps (dt/that)^2; see doc/theory/contact.md. `step` is the stable step of the
  /// elements [s], `bulk_modulus` the mean of both bodies [Pa], `cell_size` that of the surface cells [m].
  Penalty
  make_penalty(double scale, double bulk_modulus, double cell_size, double damping_ratio, double step);

  /// Puts the added mass [kg/m2] on the nodes of a surface that this rank holds; mass [kg] has one
  /// number a node.
  void
  add_surface_mass(const Surface &surface, double added_mass, double *mass);
} // namespace wheelrail
