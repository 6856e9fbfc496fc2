#pragma once

#include <wheelrail/damage/wear_profile.h>
#include <wheelrail/output/summary.h>

#include <string>
#include <vector>

namespace wheelrail
{
  /// The keys of those that count for the worst patch, which are all but the section.
  const std::vector<std::string> &
  worst_wear_keys();

  /// Sets the figures of wear and cracks of a patch, from its force, area, peak pressure and T-gamma in the
  /// summary: T-gamma over its area, wear rate (usfd_wear_rate()), share of the life of one passage
  /// (burstow_damage()), largest depth and section that Archard's law takes in one passage (`wear` across the
  /// rail; empty: not known), traction over normal force, and, where the yield stress in shear is known,
  /// fatigue index and peak pressure over it, the load of shakedown maps (Johnson 1989). `tangential`: force
  /// [N], `yield_stress`: of the rail [Pa]; infinite: elastic.
  void
  set_wear_figures(const WearProfile &wear,
                   double             tangential,
                   double             yield_stress,
                   const WearData    &data,
                   Summary           &summary);
} // namespace wheelrail
