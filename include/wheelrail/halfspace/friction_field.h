#pragma once

#include <wheelrail/halfspace/problem.h>
#include <wheelrail/halfspace/tangential.h>

#include <vector>

namespace wheelrail
{
  /// Friction coefficient at a slip velocity [m/s] whose law has `law`: that or, with a memory, what a
  /// particle has come to that entered the element with the coefficient `ahead`, in the time of one step [m].
  double
  friction_of_particle(const HalfspaceProblem &problem,
                       double                  law,
                       double                  velocity,
                       double                  ahead,
                       double                  step);

  /// What the temperature of an element in row j adds to the coefficient of its law; with it no less than
  /// 1e-6 is left, as in CONTACT.
  double
  hot_friction(const HalfspaceProblem &problem, int j, double temperature);

  /// Friction coefficient of each element under a slip [-] and at the temperature of body 1 (empty: none):
  /// that of the law or, with a memory, what particles have come to that run through the row from its leading
  /// edge on, each element in the time of one step [m] and with one slip; from the state before one step.
  std::vector<double>
  friction_field(const HalfspaceProblem    &problem,
                 double                     step,
                 const VectorField         &slip,
                 const std::vector<double> &pressure,
                 const std::vector<double> &temperature);
} // namespace wheelrail
