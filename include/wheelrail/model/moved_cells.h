#pragma once

#include <wheelrail/mesh/sweep_plan.h>
#include <wheelrail/scene/scene.h>
#include <wheelrail/solid/solid.h>

namespace wheelrail
{
  /// What limits the step anywhere on the path: the stiffest cell (element_frequency_bound()) of the columns
  /// of blocks that come to have finest cells, where nodes that irregularities move lie there. Where none are
  /// moved all columns are alike, and one is looked at. Takes 10 us a cell. Mass scaling
  /// counts. Throws RunError where a cell is folded.
  StableStep
  step_on_path(const Scene &scene, const SweepPlan &plan);

  /// The start lies on the smooth surfaces, where the cells allow the step `at_start` [s]: lowers the stable
  /// step in the ratio in which those of the path do (step_on_path()), where irregularities move nodes.
  void
  lower_step_to_path(const Scene &scene, const SweepPlan &plan, double at_start, StableStep &stable);

  /// Throws InputError where mass scaling adds more than 0.1 % to a body.
  void
  check_added_mass(const Scene &scene, const MeshQuality &quality);
} // namespace wheelrail
