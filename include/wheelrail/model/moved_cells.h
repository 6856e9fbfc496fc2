#pragma once

#include <wheelrail/base/body.h>
#include <wheelrail/material/elastic.h>
#include <wheelrail/mesh/sweep_plan.h>
#include <wheelrail/solid/solid.h>

namespace wheelrail
{
  /// What limits the step anywhere on the path: the stiffest cell (element_frequency_bound()) of the columns
  /// of blocks that come to have finest cells, where nodes that irregularities move lie there. Where none are
  /// moved all columns are alike, and one is looked at. Takes 10 us a cell. Throws RunError where a cell is
  /// folded.
  StableStep
  step_on_path(const SweepPlan &plan, const PerBody<Elasticity> &steel, double bulk_viscosity);

  /// The start lies on the smooth surfaces, where the cells allow the step `at_start` [s]: lowers the stable
  /// step in the ratio in which those of the path do (step_on_path()), where irregularities move nodes.
  void
  lower_step_to_path(const SweepPlan           &plan,
                     const PerBody<Elasticity> &steel,
                     double                     bulk_viscosity,
                     double                     at_start,
                     StableStep                &stable);
} // namespace wheelrail
