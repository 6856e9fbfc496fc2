#pragma once

#include <wheelrail/halfspace/kernels.h>
#include <wheelrail/halfspace/problem.h>

#include <memory>
#include <vector>

namespace wheelrail
{
  /// Rows of a grid whose pressures displace each other less than half-spaces do, as CONTACT joins two
  /// overlaps that are neither one patch nor two.
  struct RowDivision
  {
    double place  = 0; ///< y of the problem between the parts [m]
    double factor = 1; ///< of the influence of each neighbouring part on the other; of others none is left
  };

  /// solve_rolling() of a problem with such divisions, ascending: what is missing of the influences of the
  /// pressure comes to the undeformed distance, in rounds until it holds to 1e-5 of the approach; tractions
  /// act in full, as in CONTACT.
  HalfspaceSolution
  solve_weakened(HalfspaceProblem                   problem,
                 const std::vector<RowDivision>    &divisions,
                 std::shared_ptr<HalfspaceKernels> &kernels,
                 const HalfspaceSolution           *guess = nullptr);
} // namespace wheelrail
