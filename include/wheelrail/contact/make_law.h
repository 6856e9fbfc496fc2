#pragma once

#include <wheelrail/contact/contact_law.h>
#include <wheelrail/material/elasticity.h>
#include <wheelrail/solid/element_form.h>

namespace wheelrail
{
  /// One of the bodies that touch.
  struct ContactBody
  {
    Elasticity  material;
    ElementForm form  = ElementForm::reduced;
    bool        rigid = false; ///< without elements: its material and form are of no account
  };

  /// What is chosen for a contact.
  struct ContactChoice
  {
    double      penalty_scale = 10;   ///< effective scale f
    double      cell_size     = 1e-3; ///< of the surface cells [m]
    double      damping_ratio = 0.3;  ///< fraction of the critical damping
    FrictionLaw friction;
    bool        surface_filter = true; ///< of bodies that are not rigid
  };

  /// The law of a contact between two bodies: the only place where one is put together.
  ///
  /// Penalty stiffness eps = f K / h, K the mean bulk modulus of the bodies that are not rigid, with the
  /// added ("bipenalty") mass that keeps the contact springs from shortening the step (Askes,
  /// Caramés-Saddler and Rodríguez-Ferran 2010). A spring eps between two masses m per area swings at
  /// sqrt(2 eps/m). With the damping ratio z, the damper taken at the half step behind, central differences
  /// are stable up to omega dt = 2 (sqrt(1 + z^2) - z), so m = 2 eps (dt/that)^2, but omega dt is 1.5 at
  /// most: nodes that open and close gain energy near the limit of linear stability; see
  /// doc/theory/contact.md. `step` is the stable step of the elements [s]. Filters as surface_filter() says.
  ContactLaw
  make_contact_law(const PerBody<ContactBody> &bodies, const ContactChoice &choice, double step);
} // namespace wheelrail
