#pragma once

#include <wheelrail/halfspace/problem.h>
#include <wheelrail/halfspace/tangential.h>

#include <vector>

namespace wheelrail
{
  /// Friction coefficient at a slip velocity [m/s] in row j: that of the law or, with a memory, what a
  /// particle has come to that entered the element with the coefficient `ahead`, in the time of one step [m].
  double
  friction_of_particle(const HalfspaceProblem &problem, int j, double velocity, double ahead, double step);

  /// Friction coefficient of each element under a slip [-]: that of the law at its slip velocity or, with a
  /// memory, what particles have come to that run through the row from its leading edge on, each element in
  /// the time of one step [m] and with one slip.
  std::vector<double>
  friction_field(const HalfspaceProblem    &problem,
                 double                     step,
                 const VectorField         &slip,
                 const std::vector<double> &pressure);
} // namespace wheelrail
