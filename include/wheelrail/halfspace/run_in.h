#pragma once

#include <wheelrail/halfspace/problem.h>
#include <wheelrail/halfspace/tangential.h>

#include <vector>

namespace wheelrail
{
  /// The elements that run into a contact with these pressures [Pa] within a `step` of several elements [m];
  /// none where a step is one element, and in a shift.
  std::vector<RunIn>
  elements_run_in(const HalfspaceProblem &problem, double step, const std::vector<double> &pressure);
} // namespace wheelrail
