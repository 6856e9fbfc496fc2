#include <wheelrail/base/format_text.h>
#include <wheelrail/damage/wear_profile.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace wheelrail
{
  namespace
  {
    /// Width that belongs to a row of the patch [m].
    double
    width(const std::vector<double> &lateral, const std::size_t j)
    {
      const std::size_t before = j > 0 ? j - 1 : j, after = j + 1 < lateral.size() ? j + 1 : j;
      return after > before ? std::abs(lateral[after] - lateral[before]) / (after - before) : 0;
    }

    /// Slip of node i along in row j, averaged with those of its neighbours in contact.
    double
    averaged_slip(const PatchFields &patch, const std::size_t i, const std::size_t j)
    {
      double along = 0, lateral = 0, weights = 0;
      for (std::size_t k = i > 0 ? i - 1 : i; k <= i + 1 && k < patch.n_along; ++k)
        if (const std::size_t e = j + patch.n_lateral * k; patch.pressure[e] > 0)
          {
            const double weight = k == i ? 2 : 1;
            weights += weight;
            along += weight * patch.slip_along[e];
            lateral += weight * patch.slip_lateral[e];
          }
      return weights > 0 ? std::hypot(along, lateral) / weights : 0;
    }
  } // namespace


  WearProfile
  wear_profile(const PatchFields &patch, const double velocity, const WearData &data, const bool of_nodes)
  {
    WearProfile profile;
    // nodes go across the rail first
    profile.lateral.assign(patch.lateral.begin(), patch.lateral.begin() + patch.n_lateral);
    profile.depth.assign(patch.n_lateral, 0);
    profile.work.assign(patch.n_lateral, 0);
    for (std::size_t j = 0; j < patch.n_lateral; ++j)
      {
        const double row = width(profile.lateral, j);
        for (std::size_t i = 0; i < patch.n_along && row > 0; ++i)
          {
            const std::size_t e    = j + patch.n_lateral * i;
            const double      step = patch.area[e] / row,
                         slip      = std::hypot(patch.slip_along[e], patch.slip_lateral[e]),
                         k = archard_coefficient(velocity * (of_nodes ? averaged_slip(patch, i, j) : slip),
                                                 patch.pressure[e],
                                                 data);
            profile.depth[j] += k * patch.pressure[e] * slip * step / data.hardness;
            profile.work[j] += step * (patch.traction_along[e] * patch.slip_along[e] +
                                       patch.traction_lateral[e] * patch.slip_lateral[e]);
          }
      }
    return profile;
  }


  FigureTable
  empty_wear_table()
  {
    FigureTable table;
    table.add("patch", "1", {});
    table.add("lateral_m", "m", {});
    table.add("archard_depth_m", "m", {});
    table.add("friction_work_N_per_m", "N/m", {});
    return table;
  }


  void
  add_to_table(const WearProfile &profile, const unsigned int patch, FigureTable &table)
  {
    for (std::size_t j = 0; j < profile.lateral.size(); ++j)
      table.add_row({double(patch), profile.lateral[j], profile.depth[j], profile.work[j]});
  }


  void
  write_wear(const WearProfile &profile, const std::string &path)
  {
    if (profile.lateral.empty())
      return;
    FigureTable table = empty_wear_table();
    add_to_table(profile, 1, table);
    table.write_csv(path);
  }


  double
  over_width(const WearProfile &profile, const std::vector<double> &values)
  {
    double sum = 0;
    for (std::size_t j = 0; j < values.size(); ++j)
      sum += values[j] * width(profile.lateral, j);
    return sum;
  }


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
