#pragma once

#include <wheelrail/halfspace/problem.h>

#include <string>
#include <vector>

namespace wheelrail
{
  /// Fills in what follows from the tractions of a solution, its creepages and its rigid slip: state of the
  /// elements, forces [N], spin moment [N m], peaks [Pa], areas [m2], extents [m], and the work of creepage.
  /// `slipping`: of each element that touches, whether it slips; empty without friction.
  void
  measure(const HalfspaceProblem &problem, const std::vector<char> &slipping, HalfspaceSolution &solution);

  /// What a solution did not reach, in sentences; empty where it has converged.
  std::string
  not_reached(const HalfspaceProblem &problem, const HalfspaceSolution &solution);
} // namespace wheelrail
