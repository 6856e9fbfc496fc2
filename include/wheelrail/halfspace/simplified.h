#pragma once

#include <wheelrail/halfspace/problem.h>
#include <wheelrail/halfspace/tangential.h>

#include <vector>

namespace wheelrail
{
  /// Tractions of simplified theory in steady rolling (FASTSIM, Kalker 1982): row by row from the leading
  /// edge on, u = u' - step w, t = u / L, cut to friction's limit. The coefficient of each element is that of
  /// its own slip, the largest that fits. Creepages of given forces are found by halving their intervals.
  /// `task` needs no kernels.
  void
  solve_simplified(const HalfspaceProblem    &problem,
                   double                     step,
                   const std::vector<double> &pressure,
                   const TangentialTask      &task,
                   TangentialState           &state,
                   std::vector<double>       &friction);
} // namespace wheelrail
