#pragma once

#include <wheelrail/halfspace/problem.h>

#include <vector>

namespace wheelrail
{
  struct SolvedProblem
  {
    HalfspaceProblem  problem;
    HalfspaceSolution solution;
  };

  /// A problem and, twice, the same on means over two by two elements, whose edges lie in two ways to those
  /// of the contact: what the size of elements makes of a solution (Richardson's extrapolation). All without
  /// what bodies add, whose influence has its own grid, so that of true bodies half-spaces with the same
  /// distance and rigid slip are compared; without rolling where the patch slides as a whole.
  std::vector<SolvedProblem>
  on_doubled_elements(const HalfspaceProblem &problem, const HalfspaceSolution &solution);
} // namespace wheelrail
