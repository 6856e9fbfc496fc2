#include <wheelrail/material/friction.h>

#include <algorithm>
#include <cmath>

namespace wheelrail
{
  double
  friction_coefficient(const FrictionLaw &law, const double speed)
  {
    const double drop = law.at_rest - law.at_speed;
    switch (law.kind)
      {
        case FrictionKind::exponential:
          return law.at_speed + drop * std::exp(-law.decay * speed);
        case FrictionKind::rational:
          return law.at_speed + drop / (1 + speed / law.half_velocity);
        default:
          return law.at_rest;
      }
  }


  bool
  depends_on_speed(const FrictionLaw &law)
  {
    return law.kind != FrictionKind::constant && law.at_speed != law.at_rest &&
           (law.kind != FrictionKind::exponential || law.decay != 0);
  }


  double
  steepest_fall(const FrictionLaw &law)
  {
    const double drop = std::max(0., law.at_rest - law.at_speed);
    switch (law.kind)
      {
        case FrictionKind::exponential:
          return drop * law.decay;
        case FrictionKind::rational:
          return drop / law.half_velocity;
        default:
          return 0;
      }
  }


  bool
  frictionless(const FrictionLaw &law)
  {
    return law.at_rest == 0 && (law.kind == FrictionKind::constant || law.at_speed == 0);
  }
} // namespace wheelrail
