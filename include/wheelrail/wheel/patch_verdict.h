#pragma once

#include <wheelrail/scene/scene.h>
#include <wheelrail/verdict/verdict.h>
#include <wheelrail/wheel/halfspace_case.h>

namespace wheelrail
{
  /// From the least to the largest inclination that the patches reach [rad].
  double
  turn_across_all(const WheelRailSolution &result);

  /// The verdict of one patch by its pressure, edges, elements and steel; `turn`: of the surfaces across the
  /// contact [rad], `contributions`: what is known of its results.
  Verdict
  judge_with(const Scene             &scene,
             const WheelRailSolution &result,
             double                   turn,
             const Contributions     &contributions);
} // namespace wheelrail
