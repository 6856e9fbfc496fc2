#include <wheelrail/application/compare_command.h>
#include <wheelrail/application/report_script.h>
#include <wheelrail/base/errors.h>
#include <wheelrail/model/profile_copies.h>
#include <wheelrail/model/scene_checks.h>
#include <wheelrail/model/scene_geometry.h>
#include <wheelrail/output/figures.h>
#include <wheelrail/output/hdf5_file.h>
#include <wheelrail/output/replace_file.h>
#include <wheelrail/reference/halfspace_stresses.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>

namespace wheelrail
{
  namespace
  {
    /// The figures of the table; the first two are given to the half-spaces.
    const char *const compared[] = {"vertical_force",
                                    "longitudinal_force",
                                    "normal_force",
                                    "lateral_force",
                                    "max_pressure",
                                    "max_pressure_fitted",
                                    "contact_area",
                                    "patch_lateral",
                                    "patch_longitudinal",
                                    "max_shear_traction",
                                    "creepage",
                                    "t_gamma",
                                    "stick_fraction"};

    bool
    is_given(const std::string &name)
    {
      return name == "vertical_force" || name == "longitudinal_force";
    }

    std::string
    text(const char *format, const double value)
    {
      char buffer[64];
      std::snprintf(buffer, sizeof(buffer), format, value);
      return buffer;
    }

    nlohmann::ordered_json
    number(const double value)
    {
      return std::isfinite(value) ? nlohmann::ordered_json(value) : nlohmann::ordered_json();
    }

    /// The difference of a figure and what it is relative to: the half-spaces' value, or the vertical load
    /// for the lateral force, which is small beside it and may be about zero.
    double
    relative_difference(const std::string &name, const double fe, const double hs, const double load)
    {
      const double base = name == "lateral_force" ? load : std::abs(hs);
      return base > 0 ? (fe - hs) / base : Summary::none;
    }

    /// Prints the table, adds the figures to the run's summary, returns the table for compare.json.
    nlohmann::ordered_json
    compare_figures(Summary &run, const Summary &halfspace, std::ostream &out)
    {
      nlohmann::ordered_json table = nlohmann::ordered_json::array();
      char                   row[200];
      std::snprintf(
        row, sizeof(row), "  %-40s %12s %12s %-5s %11s\n", "", "finite el.", "half-space", "", "difference");
      out << row;
      for (const char *name : compared)
        {
          const Figure     &figure = figure_named(name);
          const std::string label  = std::string(figure.label) + (is_given(name) ? " (given)" : "");
          const double      fe = get_figure(run, figure.key()), hs = get_figure(halfspace, figure.key());
          const double      difference  = relative_difference(name, fe, hs, run.vertical_force);
          const char *const relative_to = std::string(name) == "lateral_force" ? "load" : "";
          const std::string percent =
            std::isfinite(difference) ? text("%+.2f", 100 * difference) + " %" : "-";
          std::snprintf(row,
                        sizeof(row),
                        "  %-40s %12s %12s %-5s %11s%s%s\n",
                        label.c_str(),
                        figure.shown(fe).c_str(),
                        figure.shown(hs).c_str(),
                        figure.unit,
                        percent.c_str(),
                        *relative_to ? " of the " : "",
                        relative_to);
          out << row;
          set_figure(run, "halfspace_" + figure.key(), hs);
          set_figure(run, std::string("relative_difference_") + name, difference);
          table.push_back({{"key", figure.key()},
                           {"label", label},
                           {"unit", figure.unit},
                           {"factor", figure.factor},
                           {"decimals", figure.decimals},
                           {"fe", number(fe)},
                           {"fe_std", number(get_figure(run, figure.key("_std")))},
                           {"halfspace", number(hs)},
                           {"relative_difference", number(difference)},
                           {"relative_to", relative_to}});
        }
      return table;
    }

    double
    bulk_modulus(const MaterialData &material)
    {
      return material.youngs_modulus / (3 * (1 - 2 * material.poissons_ratio));
    }

    Trust
    trust_of(const Scene             &scene,
             const Summary           &run,
             const WheelRailSolution &result,
             const double             peak_at_rest)
    {
      Trust trust;
      trust.peak_difference = run.max_pressure / result.solution.peak_pressure - 1;
      trust.cells           = std::min(result.measures.width, result.measures.length) / scene.cell_size;
      trust.penetration     = run.max_pressure * scene.cell_size /
                          (scene.penalty_scale *
                           std::min(bulk_modulus(scene.rail_material), bulk_modulus(scene.wheel_material))) /
                          result.solution.approach;
      trust.unsteadiness =
        std::max(get_figure(run, "vertical_force_std_N"), get_figure(run, "longitudinal_force_std_N")) /
        run.vertical_force;
      trust.turn        = result.turn;
      trust.pose_effect = result.solution.peak_pressure / peak_at_rest - 1;
      if (run.max_plastic_strain > 0)
        trust.plastic_strain = run.max_plastic_strain;
      if (const double patches = get_figure(run, "patches"); patches > 1)
        trust.patches = patches;
      return trust;
    }

    nlohmann::ordered_json
    trust_json(const Trust &trust)
    {
      return {{"peak_difference", number(trust.peak_difference)},
              {"cells_over_shorter_extent", number(trust.cells)},
              {"penetration_over_approach", number(trust.penetration)},
              {"force_std_over_load", number(trust.unsteadiness)},
              {"turn_across_patch_rad", number(trust.turn)},
              {"pose_effect_on_peak", number(trust.pose_effect)},
              {"max_plastic_strain", number(trust.plastic_strain)},
              {"patches", number(trust.patches)},
              {"penalty_part_of_peak_difference", number(trust.penalty_part())},
              {"mesh_part_of_peak_difference", number(trust.mesh_part())}};
    }
  } // namespace


  namespace
  {
    bool
    is_flat(const Trust &trust)
    {
      return trust.turn < 0.2;
    }

    bool
    half_spaces_fit(const Trust &trust)
    {
      return is_flat(trust) && !(trust.plastic_strain > 0) && !(trust.patches > 1);
    }

    /// How far the peak agrees, or why half-spaces are no reference for it.
    std::string
    verdict(const Trust &trust)
    {
      std::string why;
      if (trust.plastic_strain > 0)
        why += "steel has flowed (plastic strain up to " + text("%.2g", 1e3 * trust.plastic_strain) + "e-3)";
      if (!is_flat(trust))
        why += (why.empty() ? "" : " and ") +
               ("the surfaces turn by " + text("%.0f", trust.turn * 180 / M_PI)) +
               " degrees across the patch";
      if (trust.patches > 1)
        why += (why.empty() ? "" : " and ") + ("the run has " + text("%.0f", trust.patches)) + " patches";
      const double      difference = std::abs(trust.peak_difference);
      const std::string percent    = text("%.1f", std::max(0.1, 100 * difference));
      if (!why.empty())
        return "The half-spaces are no full reference here, since " + why +
               "; the peak pressures differ by " + percent + " %";
      if (difference <= 0.02)
        return "The finite element result agrees with the half-spaces within " + percent +
               " % in peak pressure and can be trusted as far";
      if (difference <= 0.05)
        return "The finite element result can be trusted to about " + text("%.0f", 100 * difference) +
               " % in peak pressure";
      return "The finite element result is off by " + text("%.0f", 100 * difference) +
             " % in peak pressure and shows tendencies only";
    }

    /// What the difference of the peaks is made of.
    std::string
    parts_sentence(const Trust &trust)
    {
      const auto   percent = [](const double part) { return text("%+.1f", 100 * part) + " %"; };
      const double rest    = trust.peak_difference - trust.penalty_part() - trust.mesh_part();
      std::string  rest_is = "the rest";
      if (trust.plastic_strain > 0)
        rest_is = "yielding, which half-spaces know nothing of";
      else if (!is_flat(trust))
        rest_is = "the curved contact";
      else if (trust.patches > 1)
        rest_is = "the other patch";
      else if (!(trust.unsteadiness < 0.01))
        rest_is = "forces that are not steady";
      return "Of the difference of " + percent(trust.peak_difference) +
             " in peak pressure the penalty contact makes about " + percent(trust.penalty_part()) +
             ", the cells " + percent(trust.mesh_part()) + ", " + rest_is + " " + percent(rest) + ".";
    }
  } // namespace


  std::string
  trust_sentence(const Scene &scene, const Trust &trust, const bool finished)
  {
    // the rules of doc/manual/compare.md
    const bool steady = trust.unsteadiness < 0.01, stiff = trust.penetration < 0.02, fine = trust.cells >= 12;
    std::string sentence = finished ? "" : "The run did not finish, so take its figures with care. ";
    sentence += verdict(trust);
    const bool one = std::round(trust.cells) == 1;
    sentence += ": " + text("%.0f", trust.cells) + (one ? " cell of " : " cells of ") +
                text("%g", 1e3 * scene.cell_size) + " mm over the shorter extent of the patch " +
                (one ? "is " : "are ") + (fine ? "enough" : "too few (take at least 12)") +
                ", the penalty contact sinks in by " + text("%.1f", 100 * trust.penetration) +
                " % of the approach (" + (stiff ? "small" : "too soft: raise Contact/Penalty scale") + ")";
    if (std::isfinite(trust.unsteadiness))
      sentence += ", the forces vary by " + text("%.2f", 100 * trust.unsteadiness) + " % of the load (" +
                  (steady ? "steady" : "not steady: roll farther") + ")";
    if (is_flat(trust))
      sentence += ", and the surfaces turn by only " + text("%.0f", trust.turn * 180 / M_PI) +
                  " degrees across the patch" +
                  (half_spaces_fit(trust) ? ", so that half-spaces are a fair reference" : "");
    return sentence + ". " + parts_sentence(trust);
  }


  WheelRailLoad
  load_of_run(const Summary &run)
  {
    WheelRailLoad load;
    load.force        = run.vertical_force;
    load.vertical     = true;
    load.longitudinal = run.longitudinal_force;
    // a force at its bound says no more of the creepage
    load.slides = run.stick_fraction < 1e-3 && std::abs(run.longitudinal_force) > 1e-3 * run.vertical_force;
    return load;
  }


  SectionOffsets
  offsets_of_run(const Summary &run)
  {
    const auto value = [&](const char *key) {
      const double figure = get_figure(run, key);
      return std::isfinite(figure) ? figure : 0;
    };
    return {value("relative_lateral_m"), value("rail_head_roll_rad"), value("wheel_rim_roll_rad")};
  }


  int
  run_compare_command(const std::string              &folder,
                      const std::vector<std::string> &sets,
                      const bool                      draws,
                      std::ostream                   &out)
  {
    const std::filesystem::path path  = folder;
    Summary                     run   = read_summary((path / "summary.json").string());
    SceneInput                  input = read_scene((path / "parameters.prm").string(), sets);
    use_kept_profiles(input.scene, folder);
    const SceneGeometry geometry = require_computable(input);
    const Scene        &scene    = input.scene;
    if (!std::isfinite(run.vertical_force) || !std::isfinite(run.longitudinal_force))
      throw RunError(
        "The file \"" + (path / "summary.json").string() +
        "\" holds no vertical_force_N and longitudinal_force_N: the run did not get so far that its "
        "patch could be compared.");
    const WheelRailLoad     load         = load_of_run(run);
    const SectionOffsets    offsets      = offsets_of_run(run);
    const WheelRailSolution result       = solve_wheel_rail(scene, geometry, load, offsets);
    const double            peak_at_rest = solve_wheel_rail(scene, geometry, load, {}).solution.peak_pressure;
    const Summary           halfspace    = halfspace_summary(scene, result);

    out << run.title << "\nMeans of the run against half-spaces on elements of "
        << 1e3 * result.solution.grid.dx << " mm, wheel moved by " << text("%.3f", 1e3 * offsets.lateral)
        << " mm and rail turned by " << text("%.3f", 1e3 * (offsets.wheel_roll - offsets.rail_roll))
        << " mrad to the track centre\n";
    nlohmann::ordered_json table    = compare_figures(run, halfspace, out);
    const Trust            trust    = trust_of(scene, run, result, peak_at_rest);
    const std::string      sentence = trust_sentence(scene, trust, run.finished);
    out << '\n' << sentence << std::endl;
    if (!halfspace.finished)
      out << "The half-space solution is not exact: " << halfspace.stop_reason << std::endl;

    nlohmann::ordered_json json = {{"title", run.title},
                                   {"program_version", WHEELRAIL_VERSION},
                                   {"element_size_m", result.solution.grid.dx},
                                   {"friction_coefficient", scene.friction_coefficient},
                                   {"lateral_offset_m", offsets.lateral},
                                   {"rail_roll_rad", offsets.rail_roll},
                                   {"wheel_roll_rad", offsets.wheel_roll},
                                   {"halfspace_converged", halfspace.finished},
                                   {"figures", std::move(table)},
                                   {"trust", trust_json(trust)},
                                   {"sentence", sentence}};
    replace_file((path / "compare.json").string(),
                 json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n");
    TickFile patches((path / "halfspace.h5").string(), false, 0);
    append_patch(patches, result.patch);
    TickFile slices((path / "halfspace_slices.h5").string(), false, 0);
    append_slices(slices, result.patch.time, result.patch.rolled_distance, halfspace_stresses(result).slices);
    write_summary(run, (path / "summary.json").string());
    const int drawn = draws ? run_script("compare.py", {path.string()}) : 0;
    return halfspace.finished && drawn == 0 ? 0 : 2;
  }
} // namespace wheelrail
