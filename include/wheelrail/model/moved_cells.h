#pragma once

#include <wheelrail/mesh/sweep_plan.h>

namespace wheelrail
{
  /// How much smaller, relatively, the stable step of finest cells gets anywhere on the path by nodes that
  /// irregularities move: the least stretch of a cell, the smallest singular value of its deformation
  /// gradient, by whose inverse gradients in it grow. At most 1.
  double
  thinnest_cells(const SweepPlan &plan);
} // namespace wheelrail
