#include <wheelrail/damage/wear_figures.h>

#include <algorithm>
#include <cmath>

namespace wheelrail
{
  const std::vector<std::string> &
  worst_wear_keys()
  {
    static const std::vector<std::string> keys = {"t_gamma_over_area_N_per_m2",
                                                  "usfd_wear_rate_kg_per_m3",
                                                  "burstow_damage",
                                                  "utilised_friction",
                                                  "fatigue_index",
                                                  "shakedown_load",
                                                  "archard_depth_m"};
    return keys;
  }


  void
  set_wear_figures(const WornContact &contact, const WearData &data, Summary &summary)
  {
    if (!(contact.area > 0) || !(contact.normal_force > 0))
      return;
    const auto   set       = [&](const char *key, const double value) { set_figure(summary, key, value); };
    const double intensity = contact.t_gamma / contact.area;
    set("t_gamma_over_area_N_per_m2", intensity);
    set("usfd_wear_rate_kg_per_m3", usfd_wear_rate(intensity));
    set("burstow_damage", burstow_damage(contact.t_gamma, data));
    const double traction = contact.tangential_force / contact.normal_force;
    set("utilised_friction", traction);
    // k = sigma_y / sqrt(3) (von Mises 1913)
    const double shear_yield =
      std::isfinite(data.shear_yield) ? data.shear_yield : contact.yield_stress / std::sqrt(3.);
    if (std::isfinite(shear_yield))
      {
        set("fatigue_index", fatigue_index(traction, shear_yield, contact.peak_pressure));
        set("shakedown_load", contact.peak_pressure / shear_yield);
      }
    if (!contact.wear || contact.wear->depth.empty())
      return;
    const WearProfile &profile = *contact.wear;
    set("archard_depth_m", *std::max_element(profile.depth.begin(), profile.depth.end()));
    set("archard_section_m2", over_width(profile, profile.depth));
  }
} // namespace wheelrail
