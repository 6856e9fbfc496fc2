#include <wheelrail/base/format_text.h>
#include <wheelrail/damage/wear_figures.h>

#include <algorithm>
#include <cmath>

namespace wheelrail
{
  const std::vector<std::string> &
  worst_wear_keys()
  {
    static const std::vector<std::string> keys = split_list(
      "t_gamma_over_area_N_per_m2, usfd_wear_rate_kg_per_m3, burstow_damage, utilised_friction, "
      "fatigue_index, shakedown_load, archard_depth_m");
    return keys;
  }


  void
  set_wear_figures(const WearProfile &wear,
                   const double       tangential,
                   const double       yield_stress,
                   const WearData    &data,
                   Summary           &summary)
  {
    const double area = summary.contact_area, peak = summary.max_pressure, force = summary.normal_force,
                 t_gamma = get_figure(summary, "t_gamma_N");
    if (!(area > 0) || !(force > 0))
      return;
    const auto set = [&](const char *key, const double value) { set_figure(summary, key, value); };
    set("t_gamma_over_area_N_per_m2", t_gamma / area);
    set("usfd_wear_rate_kg_per_m3", usfd_wear_rate(t_gamma / area));
    set("burstow_damage", burstow_damage(t_gamma, data));
    set("utilised_friction", tangential / force);
    // k = sigma_y / sqrt(3) (von Mises 1913)
    const double shear_yield =
      std::isfinite(data.shear_yield) ? data.shear_yield : yield_stress / std::sqrt(3.);
    if (std::isfinite(shear_yield))
      {
        set("fatigue_index", fatigue_index(tangential / force, shear_yield, peak));
        set("shakedown_load", peak / shear_yield);
      }
    if (wear.depth.empty())
      return;
    set("archard_depth_m", *std::max_element(wear.depth.begin(), wear.depth.end()));
    set("archard_section_m2", over_width(wear, wear.depth));
  }
} // namespace wheelrail
