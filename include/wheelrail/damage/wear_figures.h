#pragma once

#include <wheelrail/damage/wear_profile.h>
#include <wheelrail/output/summary.h>

#include <string>
#include <vector>

namespace wheelrail
{
  /// One patch, as wear and crack laws see it; SI units.
  struct WornContact
  {
    const WearProfile *wear         = nullptr;                 ///< across the rail; null: not known
    double             normal_force = 0, tangential_force = 0; ///< magnitudes [N]
    double             peak_pressure = 0, area = 0;            ///< [Pa], [m2]
    double             t_gamma = 0, velocity = 0;              ///< [N], [m/s]
    double             yield_stress = 0;                       ///< of the rail [Pa]; infinite: elastic
  };

  /// The keys of those that count for the worst patch, which are all but the section.
  const std::vector<std::string> &
  worst_wear_keys();

  /// Sets the figures of wear and cracks of a patch: T-gamma over its area, wear rate (usfd_wear_rate()),
  /// share of the life of one passage (burstow_damage()), largest depth and section that Archard's law takes
  /// in one passage (wear_profile()), traction over normal force, and, where the yield stress in shear is
  /// known, fatigue index and peak pressure over it, the load of shakedown maps (Johnson 1989).
  void
  set_wear_figures(const WornContact &contact, const WearData &data, Summary &summary);
} // namespace wheelrail
