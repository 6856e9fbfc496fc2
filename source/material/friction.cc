#include <wheelrail/material/friction.h>

#include <algorithm>
#include <cmath>

// Laws of doc/theory/contact.md, Friction: constant; exponential, the static and dynamic coefficient and
// decay of explicit codes; rational, CONTACT's.

namespace wheelrail
{
  double
  FrictionLaw::at(const double speed) const
  {
    // mu(v) of doc/theory/contact.md, Friction law: d + (s - d) exp(-c v), or d + (s - d) / (1 + v/v_h) as in
    // CONTACT
    // s = at_rest, d = at_speed, c = decay [s/m], v_h = half_velocity [m/s], where half of the fall is gone;
    // v >= 0 is the slip speed [m/s]
    const double drop = at_rest - at_speed;
    switch (kind)
      {
        case FrictionKind::exponential:
          return at_speed + drop * std::exp(-decay * speed);
        case FrictionKind::rational:
          return at_speed + drop / (1 + speed / half_velocity);
        default:
          return at_rest;
      }
  }


  double
  FrictionLaw::largest() const
  {
    return kind == FrictionKind::constant ? at_rest : std::max(at_rest, at_speed);
  }


  double
  FrictionLaw::sliding() const
  {
    // the limit of mu(v) for large v
    return kind == FrictionKind::constant ? at_rest : at_speed;
  }


  FrictionLaw
  FrictionLaw::with_rest(const double coefficient) const
  {
    FrictionLaw law = *this;
    if (at_rest > 0)
      // the same shape: mu(v) times a factor
      law.at_speed *= coefficient / at_rest;
    law.at_rest = coefficient;
    return law;
  }


  bool
  FrictionLaw::valid() const
  {
    // friction that rises with speed, d > s, is accepted, too
    return at_rest >= 0 && at_speed >= 0 && decay >= 0 && half_velocity > 0;
  }


  bool
  FrictionLaw::depends_on_speed() const
  {
    return kind != FrictionKind::constant && at_speed != at_rest &&
           (kind != FrictionKind::exponential || decay != 0);
  }


  double
  FrictionLaw::steepest_fall() const
  {
    // -dmu/dv where it is largest, at rest
    // of the exponential law (s - d) c, of the rational one (s - d)/v_h [s/m]. Times the pressure it is
    // compared with the impedance rho c_s/2 of shear waves: beyond it friction is unstable
    // (doc/theory/contact.md, Friction).
    const double drop = std::max(0., at_rest - at_speed);
    switch (kind)
      {
        case FrictionKind::exponential:
          return drop * decay;
        case FrictionKind::rational:
          return drop / half_velocity;
        default:
          return 0;
      }
  }


  bool
  FrictionLaw::frictionless() const
  {
    return at_rest == 0 && (kind == FrictionKind::constant || at_speed == 0);
  }
} // namespace wheelrail
