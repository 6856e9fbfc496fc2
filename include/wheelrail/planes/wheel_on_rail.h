#pragma once

#include <wheelrail/halfspace/problem.h>
#include <wheelrail/material/elasticity.h>

namespace wheelrail
{
  /// What rail and wheel are made of, as half-spaces.
  struct HalfspaceSteels
  {
    Elasticity rail, wheel;
  };

  /// The problem of a wheel on a rail in one plane, with the rail as body 1 (x forwards, y to the track
  /// centre, n down into the rail); grid, surfaces, motion and load are still to be set.
  HalfspaceProblem
  wheel_on_rail(const HalfspaceSteels &steels, const FrictionLaw &friction, double velocity);
} // namespace wheelrail
