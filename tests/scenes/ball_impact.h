#pragma once

// An elastic ball that falls on a rigid plane.

#include "dynamics.h"
#include "shapes.h"

namespace scenes
{
  /// What was found over what Hertz's theory of impact says (Johnson, Contact Mechanics, 1985, section
  /// 11.4), waves in the ball left out.
  struct BallImpact
  {
    double        force, duration;             ///< largest force, duration of the contact
    double        impulse;                     ///< over twice the momentum
    double        stabilisation;               ///< largest part of the strain energy around the turning point
    double        residual;                    ///< of the energy balance over the energy at the start
    double        hertz_force, hertz_duration; ///< [N, s]
    std::size_t   cells;
    unsigned long steps;
  };

  /// A ball of 10 mm radius with the velocity given [m/s]; a quarter of it is computed.
  BallImpact
  ball_impact(const Setup &setup, double velocity, const BallCells &cells);
} // namespace scenes
