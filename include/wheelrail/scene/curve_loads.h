#pragma once

#include <wheelrail/scene/scene.h>

namespace wheelrail
{
  /// What a curve demands of a wheelset that runs through it steadily.
  struct CurveLoads
  {
    double right = 0, left = 0; ///< vertical loads of the wheels [N]; 0: lifted
    double acceleration =
      0;                ///< lateral, that the cant leaves over; positive to the left; NaN without cant [m/s2]
    double lateral = 0; ///< force that the rails owe the wheelset, positive to the left [N]
  };

  /// Shares the load of an axle [N] between its wheels after radius, cant and velocity of the scene, and the
  /// height h of the centre of gravity. With b, half the distance of the contacts [m], and small angles
  ///
  ///   a = V^2 / R - g c / (2 b),   Q = Q0 (1 +- (h / b) a / g),
  ///
  /// the right-hand wheel (+) is the outer one where R > 0. A wheel that would be pulled is lifted, and the
  /// other one carries all. Without Track/Cant the loads stay as given, and nothing is owed.
  CurveLoads
  curve_loads(const Scene &scene, double right, double left, double half_base);
} // namespace wheelrail
