#include <wheelrail/planes/rigid_slip.h>

// Rigid slip of the rail against the wheel over V (doc/theory/halfspace.md, A wheelset in a curve;
// doc/theory/rolling.md, Shear tractions).

namespace wheelrail
{
  // w_x and w_s of doc/theory/halfspace.md, "A wheelset in a curve"
  RigidSlip
  rigid_slip(const WheelPlace &place, const WheelMotion &motion, const double creepage)
  {
    // pitch rate over V for the creepage 0: 1/(R cos(yaw)); the creepage of w_x is the constant xi that the
    // solvers add
    const double rate = 1 / motion.forward_radius;
    const double c = std::cos(place.wheel_tangent), s = std::sin(place.wheel_tangent);
    // w = (rail - wheel)/V, kappa the curvature of the path. Along the track the rail comes with -(1 - kappa
    // x), the wheel's surface goes with rate times its rolling velocity, -r at the contact: w_x = r/R - 1 on
    // straight track. Across it is the projection on e_s = (c, s) of rolling, of the lateral creepage and of
    // -kappa z.
    return {-(1 - motion.curvature * place.from_middle[0]) - rate * place.rolling[2],
            -(1 + creepage) * rate * (c * place.rolling[0] + s * place.rolling[1]) -
              (motion.lateral_creepage + motion.curvature * place.from_middle[2]) * c};
  }


  double
  wheel_spin(const WheelPlace &place, const WheelMotion &motion, const double creepage)
  {
    // phi = sin(angle)/R of the rolling wheel, less kappa cos(angle) of the path
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
