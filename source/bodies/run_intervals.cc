#include <wheelrail/bodies/run_intervals.h>
#include <wheelrail/output/figures.h>
#include <wheelrail/wheel/contact_intervals.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace wheelrail
{
  namespace
  {
    /// What cells and penalty take from the peak pressure, and what the area has more: in the runs of
    /// doc/theory/accuracy.md 1.5 times as much. The estimate is as uncertain as it is large.
    Contributions
    estimated(const Summary &run, const Measures &measures)
    {
      constexpr double of_area = 1.5, penalty_spread = 0.3;
      Contributions    contributions;
      const auto       add = [&](const char *name, const double share) {
        const double value = share * get_figure(run, figure_named(name).key());
        if (!std::isfinite(value))
          return;
        const double cells = -measures.mesh_part() * value, penalty = -measures.penalty_part() * value;
        contributions.push_back({name, "cells", cells, std::abs(cells)});
        contributions.push_back({name, "penalty layer", penalty, penalty_spread * std::abs(penalty)});
      };
      if (std::isfinite(measures.mesh_part()) && std::isfinite(measures.penetration))
        {
          add("max_pressure", 1);
          add("max_pressure_fitted", 1);
          add("contact_area", -of_area);
        }
      return contributions;
    }
  } // namespace


  Contributions
  run_contributions(const Scene         &scene,
                    const Summary       &run,
                    const Measures      &measures,
                    const NoiseEffect   &noise,
                    const Contributions &against_bodies)
  {
    if (scene.irregular())
      return {};
    Contributions contributions = against_bodies.empty() ? estimated(run, measures) : against_bodies;
    const auto    is_known = [&contributions, systematic = contributions.size()](const std::string &name) {
      const auto end = contributions.begin() + std::ptrdiff_t(systematic);
      return name == "normal_force" || name == "vertical_force" || name == "longitudinal_force" ||
             std::any_of(contributions.begin(), end, [&](const auto &one) { return one.result == name; });
    };
    for (const Figure &figure : all_figures())
      if (const double error = get_figure(run, figure.key("_error"));
          !std::isnan(error) && is_known(figure.name))
        contributions.push_back({figure.name, "noise and trend", 0, 2 * error});
    for (const Contribution &one : noise_contributions(noise, run))
      if (is_known(one.result))
        contributions.push_back(one);
    return contributions;
  }
} // namespace wheelrail
