#pragma once

#include <wheelrail/geometry/profiles.h>

namespace wheelrail
{
  /// Wheel profile S1002 with flange height 28 mm and flange thickness 32.5 mm, for a rim 135 mm
  /// wide: zones A to H and the 5 mm x 5 mm chamfer at the field side (EN 13715, UIC 510-2). The
  /// published coefficients leave a jump of 0.12 micrometres and 0.00024 degrees between zones D
  /// and C; it is kept.
  WheelProfile
  wheel_S1002();

  /// A cone 1:`ratio` through the running circle with the flank, the tip and the back of the flange of S1002,
  /// which a root of 13 mm radius joins: no profile of a standard, but the wheel of textbooks, whose rolling
  /// radius is known in closed form.
  WheelProfile
  wheel_cone(unsigned int ratio);
} // namespace wheelrail
