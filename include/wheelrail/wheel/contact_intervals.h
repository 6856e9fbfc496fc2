#pragma once

#include <wheelrail/verdict/interval.h>
#include <wheelrail/wheel/halfspace_case.h>

#include <string>
#include <vector>

namespace wheelrail
{
  /// Creepage at half of what friction carries (creep_scale()): what errors of creepages are held against.
  double
  half_saturation(const HalfspaceProblem  &problem,
                  const HalfspaceSolution &solution,
                  const PatchMeasures     &patch);

  /// What the size of elements leaves open of one patch, from the same contact on elements of twice the size
  /// (on_doubled_elements()): pressure and extents err with the second power of the size; creepage, tractions
  /// and forces of creep with the first and to one side, since what sticks begins half an element ahead of
  /// the patch (doc/theory/intervals.md).
  Contributions
  element_contributions(const WheelRailSolution &patch);

  /// What the noise of measured profiles leaves open of the results of a summary. Creepage and T-gamma follow
  /// the area (Kalker's linear theory), a creepage near nought by its value at `half` saturation, since spin
  /// and radii change, too; of lateral forces nothing is known where the noise is felt.
  Contributions
  noise_contributions(const NoiseEffect &noise, const Summary &results, double half);

  /// Contributions without those of some results, which then have no interval.
  Contributions
  without_results(Contributions contributions, const std::vector<std::string> &results);

  /// Those of a whole contact from those of its patches, whose summaries are `patches`: what adds up (forces,
  /// areas, work) has shifts and spreads that add up, too; all else that of the patch that has the result.
  Contributions
  joined_contributions(const std::vector<Contributions> &of_patches,
                       const std::vector<Summary>       &patches,
                       const Summary                    &total);
} // namespace wheelrail
