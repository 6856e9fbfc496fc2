#include <wheelrail/base/format_text.h>
#include <wheelrail/base/quantity.h>
#include <wheelrail/bodies/run_intervals.h>
#include <wheelrail/model/coarser_cells.h>
#include <wheelrail/model/scene_material.h>
#include <wheelrail/output/figures.h>
#include <wheelrail/sampling/creep_scale.h>
#include <wheelrail/verdict/rules.h>
#include <wheelrail/wheel/contact_intervals.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

// Intervals of a run (doc/theory/intervals.md, Runs): each cause gives a shift s and a spread d, which (1)
// joins. Against true bodies where these are a reference; else by two meshes, (5); else by estimate, (4).

namespace wheelrail
{
  namespace
  {
    /// Strain and residual stress of steel that barely yields depend on the cell that the highest stress
    /// meets: on 3.8 to 5.4 cells across the patch the strain was 0.1 to 1.1 of what smaller cells tend to.
    bool
    knows_strain(const Measures &measures)
    {
      constexpr double fewest = 6;
      return measures.cells >= fewest;
    }

    CreepScale
    scale_of(const Scene &scene, const Summary &run)
    {
      // bound mu N and the initial slope of the creep curve (Vermeulen and Johnson 1964, Kalker's
      // coefficients)
      return creep_scale(scene.friction.at(0) * run.normal_force,
                         // G of both bodies, harmonic mean [Pa]
                         2 / (1 / elasticity(scene.rail_material).shear_modulus() +
                              1 / elasticity(scene.wheel_material).shear_modulus()),
                         run.patch_longitudinal,
                         run.patch_lateral);
    }

    // a creepage near nought has the error of a quarter of that at half saturation, and is held against it
    // (doc/theory/intervals.md, The verdict)
    constexpr double least_creepage = 0.25;

    /// What cells of size h make of extents and creep of steel that yields, with n of them across the patch;
    /// as on 75 random scenes on cells of 3 mm (doc/theory/intervals.md).
    void
    add_yielding_creep(const Scene    &scene,
                       const Summary  &run,
                       const Measures &measures,
                       Contributions  &contributions)
    {
      // in h: length to 0.45, width from 1.3 below to 0.5 above
      constexpr double length = 0.45, width_shift = -0.4, width = 0.9;
      // over n: creepage to 1.1, T-gamma from 1.4 below to 1 above, sticking part to 0.5, lateral force over
      // the load to 0.1
      constexpr double of_creepage = 1.1, work_shift = -0.2, of_work = 1.2, of_stick = 0.5, of_force = 0.1;
      const double     h = scene.cell_size, n = measures.cells;
      const auto       add = [&](const char *name, const double shift, const double spread) {
        if (std::isfinite(shift + spread) && get_figure(run, figure_named(name).key()) != 0)
          contributions.push_back({name, "cells and penalty layer", shift, spread});
      };
      add("patch_longitudinal", 0, length * h);
      add("patch_lateral", width_shift * h, width * h);
      add("lateral_force", 0, of_force / n * run.normal_force);
      add("stick_fraction", 0, of_stick / n);
      const CreepScale patch = scale_of(scene, run);
      const double     half  = least_creepage * patch.half_saturation(),
                   creepage  = of_creepage / n * std::max(std::abs(run.creepage), half);
      if (scene.drive == Drive::rate)
        {
          // the creepage is given, and the force has the error: dF = (dF/dcreepage) dcreepage
          add("longitudinal_force", 0, patch.stiffness * patch.tangent(run.longitudinal_force) * creepage);
          return;
        }
      add("creepage", 0, creepage);
      const double t_gamma = get_figure(run, figure_named("t_gamma").key()),
                   part    = std::max(1., patch.friction_bound * half / std::abs(t_gamma)) / n;
      for (const char *name : {"t_gamma", "frictional_power"})
        {
          const double work = std::abs(get_figure(run, figure_named(name).key())) * part;
          add(name, work_shift * work, of_work * work);
        }
    }

    /// What cells and penalty layer make of it, with the laws of Measures: an elastic peak lies between that
    /// of the run and lost(false) more. Steel that flows less on large cells takes less from the peak, to the
    /// other side: within lost(). The elastic area has 1.5 times as much (doc/theory/accuracy.md); that of
    /// yielding steel was 8 % too large in the mean of 23 scenes on 3 mm. Strain and residual stress as on
    /// cells of 2 and 1 mm with three yield stresses (doc/theory/intervals.md).
    Contributions
    estimated(const Scene &scene, const Summary &run, const Measures &measures)
    {
      // Fractions of the result: peak up to 2 L higher, so that shift and spread are L each; area 3 L lower;
      // plastic strain from 0.5/n below to 3.5/n above; residual stress to 2.5/n, n the cells across the
      // patch. Steel that flows: peak known to L on both sides, area from 1.75 L below to 0.25 L above.
      constexpr double of_area = 1.5, of_yielding_area = 0.75, strain_shift = 1.5, of_strain = 2,
                       of_stress = 2.5;
      Contributions contributions;
      const auto    add = [&](const char *name, const double shift, const double spread) {
        const double value = get_figure(run, figure_named(name).key());
        // a result that is 0 or was not measured has no interval
        if (std::isfinite(spread * value) && value != 0)
          contributions.push_back({name, "cells and penalty layer", shift * value, std::abs(spread * value)});
      };
      // `lost(false)`: 2 L of (4), the most that an elastic peak lies too low
      const bool   flows = measures.has_yielded();
      const double half = 0.5 * measures.lost(false), shift = flows ? 0 : half;
      add("max_pressure", shift, half);
      add("max_pressure_fitted", shift, half);
      if (flows)
        add("contact_area", -of_yielding_area * half, half);
      else
        add("contact_area", -of_area * half, of_area * half);
      if (flows && knows_strain(measures))
        {
          // cells too large see less of it: true values lie above
          for (const char *name : {"max_plastic_strain", "rail_plastic_strain"})
            add(name, strain_shift / measures.cells, of_strain / measures.cells);
          add("max_residual_von_mises", 0, of_stress / measures.cells);
        }
      if (flows && scene.motion == "none")
        add_yielding_creep(scene, run, measures, contributions);
      return contributions;
    }

    using Names = std::vector<std::string>;

    // with which power of the cells results err (doc/theory/intervals.md)
    const Names of_second_order = split_list(
      "max_pressure, max_pressure_fitted, contact_area, "
      "largest_vertical_force, first_rail_force, second_rail_force, impact_factor, largest_pad_force, "
      "largest_pad_pull, largest_pressure");
    const Names of_first_order = split_list(
      "lateral_force, least_vertical_force, t_gamma, stick_fraction, max_shear_traction, max_von_mises, "
      "von_mises_below_cell, von_mises_on_way");
    const Names of_flow = split_list(
      "max_plastic_strain, rail_plastic_strain, plastic_strain_on_way, "
      "max_residual_von_mises, residual_forward_flow"); // first, too

    bool
    knows(const Contributions &contributions, const std::string &result)
    {
      return std::any_of(contributions.begin(), contributions.end(), [&](const Contribution &one) {
        return one.result == result;
      });
    }

    /// What the noise of the longitudinal force leaves open of creepage and friction work of bodies under it,
    /// which know nothing of the run's own noise in them; of all else infinite.
    double
    left_by_force(const std::string &result, const CreepScale &scale, const Summary &run)
    {
      // d(creepage) = dF/(dF/dcreepage), 2 standard errors of the force; T-gamma = F xi: |F| d(xi) + |xi| dF
      const double force = run.longitudinal_force, open = 2 * get_figure(run, "longitudinal_force_error_N"),
                   slip = open / (scale.stiffness * scale.tangent(force));
      if (result == "creepage")
        return slip;
      if (result == "t_gamma" || result == "frictional_power" || result == "archard_section")
        return (std::abs(force) * slip + std::abs(run.creepage) * open) *
               get_figure(run, figure_named(result).key()) / get_figure(run, "t_gamma_N");
      return std::numeric_limits<double>::infinity();
    }

    /// The largest force of a path (doc/theory/intervals.md).
    Contributions
    of_impacts(const Summary &run, const Measures &measures)
    {
      // 0.12/n of the largest force, as measured with a flat on cells of 4, 2, 1 mm against 0.5 mm
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
  two_mesh_contributions(const Scene &scene, const Summary &run, const Summary &coarser, const double cells)
  {
    Contributions contributions;
    // order p and c of (5)
    const auto differ = [&](const Names &names, const int order, const double by_chance) {
      for (const std::string &name : names)
        {
          const Figure &figure = figure_named(name);
          const double  value = get_figure(run, figure.key()), other = get_figure(coarser, figure.key()),
                       error = get_figure(coarser, figure.key("_error"));
          if (!std::isfinite(value) || !std::isfinite(other) || (value == 0 && other == 0))
            continue;
          // (5): s = (f(h) - f(2h))/(2^p - 1), d^2 = (f(h) - f(2h))^2 + (2 standard errors of f(2h))^2 + (c
          // f/n)^2
          const double change = value - other, noise = std::isfinite(error) ? 2 * error : 0;
          contributions.push_back({name,
                                   "two meshes",
                                   change / (std::exp2(order) - 1),
                                   std::hypot(change, noise, by_chance * value / cells)});
        }
    };
    differ(of_second_order, 2, 0.1);
    differ({"patch_longitudinal"}, 2, 0.45);
    differ({"patch_lateral"}, 2, 0.9);
    differ(of_first_order, 1, 0.5);
    differ(of_flow, 1, 2);
    // what is given has no error: force follows from a held rate, creepage from a torque
    differ({scene.drive == Drive::rate ? "longitudinal_force" : "creepage"}, 1, 0.5);
    return contributions;
  }


  Contributions
  run_contributions(const Scene         &scene,
                    const Summary       &run,
                    const Measures      &measures,
                    const NoiseEffect   &noise,
                    const Contributions &against_bodies,
                    const Contributions &two_meshes)
  {
    // 1. Systematic causes
    Contributions contributions = !against_bodies.empty() ? against_bodies
                                  : scene.irregular()     ? of_impacts(run, measures)
                                                          : estimated(scene, run, measures);
    // instead of estimates, and of what the true bodies do not know
    if (against_bodies.empty())
      for (const Contribution &one : two_meshes)
        contributions = without_results(std::move(contributions), {one.result});
    // two meshes also for what true bodies leave out
    const Contributions before = contributions;
    for (const Contribution &one : two_meshes)
      if (!knows(before, one.result))
        contributions.push_back(one);
    // below a cell its true value was 0.06/n to 1.6/n higher in 24 elastic runs on 1.5 to 3 mm, which no true
    // bodies are solved for
    constexpr double stress_shift = 0.8, of_stress = 0.9;
    if (const double stress = get_figure(run, "von_mises_below_cell_Pa") / measures.cells;
        !against_bodies.empty() && std::isfinite(stress) && !knows(contributions, "von_mises_below_cell"))
      contributions.push_back(
        {"von_mises_below_cell", "cells and penalty layer", stress_shift * stress, of_stress * stress});
    // 2. At an edge pressures grow with each halving of the cells: no bound
    if (without_bound(measures, measures.edge))
      contributions =
        without_results(std::move(contributions),
                        {"max_pressure", "max_pressure_fitted", "max_shear_traction", "max_von_mises"});
    if (without_bound(measures, measures.edge_on_path))
      contributions = without_results(std::move(contributions), {"largest_pressure", "von_mises_on_way"});
    if (scene.irregular()) // nothing is steady there
      return contributions;
    const auto is_known = [systematic = contributions](const std::string &name) {
      return name == "normal_force" || name == "vertical_force" || name == "longitudinal_force" ||
             knows(systematic, name);
    };
    // 3. Noise and trend, two standard errors, of results whose systematic part is known; 4. measured
    // profiles
    const CreepScale scale = scale_of(scene, run);
    for (const Figure &figure : all_figures())
      if (const double error = get_figure(run, figure.key("_error"));
          !std::isnan(error) && is_known(figure.name))
        // bodies under the run's own forces do not know its noise: of creepage and friction work that of the
        // longitudinal force is left
        contributions.push_back({figure.name,
                                 "noise and trend",
                                 0,
                                 knows(against_bodies, figure.name)
                                   ? std::min(2 * error, left_by_force(figure.name, scale, run))
                                   : 2 * error});
    // what profiles that the measured points allow change (doc/theory/geometry.md, Smoothing of measured
    // profiles)
    for (const Contribution &one : noise_contributions(noise, run, scale.half_saturation()))
      if (is_known(one.result))
        contributions.push_back(one);
    if (!measures.slides.empty()) // as fast as it likes
      contributions = without_results(std::move(contributions),
                                      {"creepage", "t_gamma", "frictional_power", "archard_section"});
    return contributions;
  }


  Known
  known_creep_of_run(const Scene &scene, const Summary &run)
  {
    // scale of the creepage c_h, of T-gamma mu N c_h
    const CreepScale patch = scale_of(scene, run);
    const double     half  = patch.half_saturation();
    Known            worst;
    for (const auto &[name, scale] :
         {std::pair<const char *, double>{"creepage", half}, {"t_gamma", patch.friction_bound * half}})
      {
        const Figure &figure = figure_named(name);
        const auto    get    = [&](const char *tail) { return get_figure(run, figure.key(tail)); };
        // reach: the farther end of the interval, over the value or a quarter of its scale
        const double value = get(""), reach = std::max(value - get("_low"), get("_high") - value),
                     within = reach / std::max(std::abs(value), least_creepage * scale);
        if (within > worst.within || (std::isnan(worst.within) && std::isfinite(within)))
          worst = {within,
                   std::min(2 * get("_error"), left_by_force(name, patch, run)) > 0.5 * reach
                     ? "noise and trend"
                     : "cells and penalty layer"};
      }
    return worst;
  }


  std::string
  without_intervals(const Scene         &scene,
                    const Measures      &measures,
                    const Contributions &against_bodies,
                    const Contributions &two_meshes)
  {
    if (!two_meshes.empty())
      return "Intervals: by the run on cells of " + in_mm(2 * scene.cell_size) +
             (against_bodies.empty() ? "." : ", where the true bodies do not know the result.");
    if (!against_bodies.empty())
      return "";
    // what would give the results without interval one
    const std::string cure =
      takes_coarser_cells(scene) ? "; Run/Error estimate = two meshes gives them." : ".";
    if (scene.irregular())
      return "Intervals: of the largest force alone; what cells make of pressures over irregular surfaces is "
             "not known" +
             cure;
    if (measures.has_yielded())
      return "Intervals: peak pressure" +
             std::string(scene.motion == "none" ? ", area, extents, creep" : ", area") +
             (knows_strain(measures) ? ", plastic strain and residual stress" : "") +
             " by estimate; all else has none, since elastic bodies are no reference of steel that yields" +
             cure;
    return "Intervals: peak pressure and area by estimate, forces by their noise; all else has none, since " +
           std::string(scene.motion != "none" ? "a guided wheel has no one place for true bodies"
                                              : "the true bodies have no answer") +
           cure;
  }
} // namespace wheelrail
