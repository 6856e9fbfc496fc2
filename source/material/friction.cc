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
    // second terms are those of CONTACT's files: half of each is gone at v_2
    const double drop = at_rest - at_speed - second_drop, second = speed / second_velocity;
    switch (kind)
      {
        case FrictionKind::exponential:
          return at_speed + drop * std::exp(-decay * speed) +
                 (second_drop == 0 ? 0 : second_drop * std::exp2(-second));
        case FrictionKind::rational:
          return at_speed + drop / (1 + speed / half_velocity) + second_drop / (1 + second * second);
        case FrictionKind::linear:
          return at_speed + drop * std::max(0., 1 - speed / (2 * half_velocity)) +
                 second_drop * std::max(0., 1 - second / 2);
        default:
          return at_rest;
      }
  }


  double
  FrictionLaw::largest() const
  {
    if (kind == FrictionKind::constant)
      return at_rest;
    if (second_drop == 0)
      return std::max(at_rest, at_speed);
    // both terms are largest at rest where they fall, at high speed where they rise
    return at_speed + std::max(0., at_rest - at_speed - second_drop) + std::max(0., second_drop);
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
      for (double *part : {&law.at_speed, &law.second_drop})
        *part *= coefficient / at_rest;
    law.at_rest = coefficient;
    return law;
  }


  bool
  FrictionLaw::valid() const
  {
    // friction that rises with speed, d > s, is accepted, too
    // no speed may have a negative coefficient: terms that rise with speed start below mu_d
    const double least =
      at_speed + std::min(0., at_rest - at_speed - second_drop) + std::min(0., second_drop);
    return at_rest >= 0 && at_speed >= 0 && decay >= 0 && half_velocity > 0 && second_velocity > 0 &&
           (second_drop == 0 || least >= 0);
  }


  bool
  FrictionLaw::depends_on_speed() const
  {
    // two coefficients that agree, or a decay of 0, leave mu constant
    return kind != FrictionKind::constant &&
           (second_drop != 0 || (at_speed != at_rest && (kind != FrictionKind::exponential || decay != 0)));
  }


  double
  FrictionLaw::steepest_fall() const
  {
    // of the exponential law (s - d) c, of the rational one (s - d)/v_h [s/m]. Times the pressure it is
    // compared with the impedance rho c_s/2 of shear waves: beyond it friction is unstable
    // (doc/theory/contact.md, Friction).
    // -dmu/dv where it is largest, at rest; of the second rational term 3 sqrt(3) / 8 at v_2 / sqrt(3)
    // the sum of both steepest falls, though they need not be at one speed: an upper bound
    const double drop   = std::max(0., at_rest - at_speed - second_drop);
    const double second = std::max(0., second_drop) / second_velocity;
    switch (kind)
      {
        case FrictionKind::exponential:
          return drop * decay + std::log(2.) * second;
        case FrictionKind::rational:
          return drop / half_velocity + 0.375 * std::sqrt(3.) * second;
        case FrictionKind::linear:
          return drop / (2 * half_velocity) + second / 2;
        default:
          return 0;
      }
  }


  bool
  FrictionLaw::frictionless() const
  {
    return at_rest == 0 && (kind == FrictionKind::constant || (at_speed == 0 && second_drop == 0));
  }
} // namespace wheelrail
