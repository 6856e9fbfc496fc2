#include <wheelrail/planes/rigid_slip.h>

namespace wheelrail
{
  // w_x and w_s of doc/theory/halfspace.md, "A wheelset in a curve"
  RigidSlip
  rigid_slip(const WheelPlace &place, const WheelMotion &motion, const double creepage)
  {
    const double rate = 1 / motion.forward_radius;
    const double c = std::cos(place.wheel_tangent), s = std::sin(place.wheel_tangent);
    return {-(1 - motion.curvature * place.from_middle[0]) - rate * place.rolling[2],
            -(1 + creepage) * rate * (c * place.rolling[0] + s * place.rolling[1]) -
              (motion.lateral_creepage + motion.curvature * place.from_middle[2]) * c};
  }


  double
  wheel_spin(const WheelPlace &place, const WheelMotion &motion, const double creepage)
  {
    return (1 + creepage) * std::sin(place.wheel_angle) / motion.forward_radius -
           motion.curvature * std::cos(place.wheel_tangent);
  }


  RowSlip
  row_slip(const WheelPlace &place, const WheelMotion &motion, const double creepage)
  {
    const RigidSlip slip = rigid_slip(place, motion, creepage);
    return {slip.along, slip.lateral, wheel_spin(place, motion, 0), place.along};
  }
} // namespace wheelrail
