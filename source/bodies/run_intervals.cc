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
    /// What cells and penalty layer take, with the laws of Measures: the true peak lies between that of the
    /// run and lost(false) more. The area has 1.5 times as much (doc/theory/accuracy.md).
    Contributions
    estimated(const Summary &run, const Measures &measures)
    {
      constexpr double of_area = 1.5;
      Contributions    contributions;
      const auto       add = [&](const char *name, const double lost) {
        const double half = 0.5 * lost * get_figure(run, figure_named(name).key());
        if (std::isfinite(half))
          contributions.push_back({name, "cells and penalty layer", half, std::abs(half)});
      };
      add("max_pressure", measures.lost(false));
      add("max_pressure_fitted", measures.lost(false));
      add("contact_area", -of_area * measures.lost(false));
      return contributions;
    }

    /// The largest force of a path, on cells of 3 mm against 1 mm (doc/theory/intervals.md).
    Contributions
    of_impacts(const Summary &run, const Measures &measures)
    {
      constexpr double over_cells = 0.12;
      Contributions    contributions;
      for (const char *name : {"largest_vertical_force", "impact_factor"})
        if (const double spread = over_cells / measures.cells * get_figure(run, figure_named(name).key());
            std::isfinite(spread))
          contributions.push_back({name, "cells", 0, spread});
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
      return of_impacts(run, measures);
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


  std::string
  without_intervals(const Scene &scene, const Measures &measures, const Contributions &against_bodies)
  {
    if (scene.irregular())
      return "Intervals: of the largest force alone; what cells make of pressures over irregular surfaces is "
             "not known.";
    if (!against_bodies.empty())
      return "";
    return std::string(
             "Intervals: peak pressure and area by estimate, forces by their noise; all else has none, "
             "since ") +
           (measures.has_yielded()   ? "elastic bodies are no reference of steel that yields."
            : scene.motion != "none" ? "a guided wheel has no one place for true bodies."
                                     : "the true bodies have no answer.");
  }
} // namespace wheelrail
