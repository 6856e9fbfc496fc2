#include <wheelrail/application/compare_command.h>
#include <wheelrail/application/halfspace_results.h>
#include <wheelrail/application/report_script.h>
#include <wheelrail/base/errors.h>
#include <wheelrail/base/format_text.h>
#include <wheelrail/base/hints.h>
#include <wheelrail/model/expected_patch.h>
#include <wheelrail/model/profile_copies.h>
#include <wheelrail/model/scene_checks.h>
#include <wheelrail/model/scene_geometry.h>
#include <wheelrail/model/scene_motion.h>
#include <wheelrail/output/figures.h>
#include <wheelrail/output/hdf5_file.h>
#include <wheelrail/output/replace_file.h>
#include <wheelrail/reference/body_pose.h>
#include <wheelrail/reference/halfspace_stresses.h>
#include <wheelrail/reference/run_reference.h>
#include <wheelrail/sampling/stress_below.h>
#include <wheelrail/verdict/agreement.h>
#include <wheelrail/verdict/verdict.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <iterator>
#include <string>
#include <vector>

namespace wheelrail
{
  namespace
  {
    /// What the difference of a figure is held against.
    struct Limit
    {
      double share  = 0; ///< of the value of the half-spaces; 0: no limit
      double amount = 0; ///< by itself [SI]; the wider one of both counts
    };

    /// A figure of the table.
    struct Compared
    {
      const char *name;
      Limit       limit;
    };

    // differences that cells of 1 mm, the penalty and the noise of a run explain, with room of about two
    // (doc/manual/compare.md)
    constexpr Limit load_limit{0.01, 0}; ///< of the lateral force of a straight wheelset: of the load

    /// The figures of the table; the first two are given to the half-spaces.
    const Compared compared[] = {{"vertical_force", {}},
                                 {"longitudinal_force", {}},
                                 {"normal_force", {0.01, 0}},
                                 {"lateral_force", {0.05, 0}},
                                 {"max_pressure", {0.05, 0}},
                                 {"max_pressure_fitted", {}},
                                 {"contact_area", {0.05, 0}},
                                 {"patch_lateral", {0.05, 0}},
                                 {"patch_longitudinal", {0.05, 0}},
                                 {"max_shear_traction", {0.05, 0}},
                                 {"creepage", {0.05, 0.15e-3}},
                                 {"t_gamma", {0.08, 2}},
                                 {"archard_section", {}},
                                 {"archard_depth", {}},
                                 {"stick_fraction", {0, 0.05}},
                                 {"surface_von_mises", {}},
                                 {"von_mises_below_cell", {0.05, 0}},
                                 {"von_mises_below_cell_depth", {0, 0.5e-3}}};

    /// Of a wheelset with yaw besides.
    const Compared compared_with_yaw[] = {{"yaw_moment", {}},
                                          {"reference_creepage", {}},
                                          {"reference_lateral_creepage", {}},
                                          {"reference_spin", {}}};

    /// Of true bodies besides: where they turn and move to is their own result.
    const Compared compared_with_bodies[] = {{"rail_head_lateral", {}},
                                             {"rail_head_roll", {}},
                                             {"wheel_rim_lateral", {}},
                                             {"wheel_rim_roll", {}}};

    bool
    is_given(const std::string &name)
    {
      return name == "vertical_force" || name == "longitudinal_force";
    }

    /// The unit of a difference of two values of a figure, behind a number: " mm", of parts " points".
    std::string
    unit_of_difference(const Figure &figure)
    {
      const std::string unit = figure.unit;
      return unit.empty() ? "" : unit == "%" ? " points" : " " + unit;
    }

    /// A limit as the table shows it, in the unit of the figure: "5 %", "5 % or 0.15 1e-3", "0.5 mm".
    std::string
    limit_text(const Limit &limit, const Figure &figure)
    {
      std::string shown = limit.share > 0 ? text("%g", 100 * limit.share) + " %" : "";
      if (limit.amount > 0)
        shown += (shown.empty() ? "" : " or ") + text("%g", figure.factor * limit.amount) +
                 unit_of_difference(figure);
      return shown;
    }

    /// A difference as the table shows it: in the unit of the figure where its limit is an amount, else over
    /// the value of the half-spaces, or over the load.
    std::string
    difference_text(double amount, double relative, const Limit &limit, bool of_load, const Figure &figure)
    {
      const bool in_units = limit.share == 0 && limit.amount > 0;
      if (!std::isfinite(in_units ? amount : relative))
        return "-";
      if (in_units)
        return text("%+.*f", figure.decimals, figure.factor * amount) + unit_of_difference(figure);
      return text("%+.2f", 100 * relative) + " %" + (of_load ? " of load" : "");
    }

    nlohmann::ordered_json
    number(const double value)
    {
      return std::isfinite(value) ? nlohmann::ordered_json(value) : nlohmann::ordered_json();
    }

    bool
    has_yaw(const Summary &run)
    {
      return std::isfinite(get_figure(run, "yaw_rad"));
    }

    /// Whether a figure counts over the vertical load: the lateral force of a straight wheelset, which is
    /// small beside it and may be about zero.
    bool
    over_load(const std::string &name, const Summary &run)
    {
      return name == "lateral_force" && !has_yaw(run);
    }

    double
    relative_difference(const double fe, const double hs, const double base)
    {
      return base > 0 ? (fe - hs) / base : Summary::none;
    }

    /// What a run is compared with: the head of its column, and what stands before the keys of its figures
    /// and of the differences.
    struct Reference
    {
      const char *title, *figures, *differences;
      const char *json; ///< the key of its value in compare.json
    };
    constexpr Reference half_spaces{"half-space", "halfspace_", "relative_difference_", "halfspace"},
      true_bodies{"true bodies", "bodies_", "bodies_relative_difference_", "bodies"};

    /// One row on the screen.
    void
    print_row(const std::string &label,
              const char        *unit,
              const std::string &fe,
              const std::string &hs,
              const std::string &difference,
              const std::string &limit,
              std::ostream      &out)
    {
      char row[240];
      std::snprintf(row,
                    sizeof(row),
                    "  %-40s %-5s %11s %12s %22s  %s\n",
                    label.c_str(),
                    unit,
                    fe.c_str(),
                    hs.c_str(),
                    difference.c_str(),
                    limit.c_str());
      out << row;
    }

    /// What a table of figures says.
    struct Comparison
    {
      nlohmann::ordered_json   table = nlohmann::ordered_json::array(); ///< for compare.json
      std::vector<std::string> beyond; ///< the figures that differ by more than their limit, with both
    };

    /// Prints the table and adds the figures to the run's summary.
    Comparison
    compare_figures(Summary &run, const Summary &halfspace, const Reference &reference, std::ostream &out)
    {
      Comparison comparison;
      print_row("", "", "finite el.", reference.title, "difference", "limit", out);
      std::vector<Compared> rows(std::begin(compared), std::end(compared));
      if (has_yaw(run))
        rows.insert(rows.end(), std::begin(compared_with_yaw), std::end(compared_with_yaw));
      if (std::isfinite(get_figure(halfspace, "rail_head_roll_rad")))
        rows.insert(rows.end(), std::begin(compared_with_bodies), std::end(compared_with_bodies));
      for (const auto &[name, own_limit] : rows)
        {
          const Figure     &figure = figure_named(name);
          const std::string label  = std::string(figure.label) + (is_given(name) ? " (given)" : "");
          const double      fe = get_figure(run, figure.key()), hs = get_figure(halfspace, figure.key());
          const bool        of_load = over_load(name, run);
          const double difference = relative_difference(fe, hs, of_load ? run.vertical_force : std::abs(hs));
          const char *const relative_to = of_load ? "load" : "";
          const Limit       limit       = of_load ? load_limit : own_limit;
          const double      off         = of_load ? std::abs(difference) : std::abs(fe - hs);
          const double      most = of_load ? limit.share : std::max(limit.share * std::abs(hs), limit.amount);
          const bool        beyond = most > 0 && off > most;
          const std::string apart  = difference_text(fe - hs, difference, limit, of_load, figure),
                            bound  = limit_text(limit, figure) + (of_load ? " of load" : "");
          print_row(label,
                    figure.unit,
                    figure.shown(fe),
                    figure.shown(hs),
                    apart,
                    bound + (beyond ? "  beyond" : ""),
                    out);
          if (beyond)
            comparison.beyond.push_back(
              std::string(label).append(" by ").append(apart).append(" (limit ").append(bound).append(")"));
          set_figure(run, reference.figures + figure.key(), hs);
          set_figure(run, std::string(reference.differences) + name, difference);
          comparison.table.push_back({{"key", figure.key()},
                                      {"label", label},
                                      {"unit", figure.unit},
                                      {"factor", figure.factor},
                                      {"decimals", figure.decimals},
                                      {"fe", number(fe)},
                                      {"fe_std", number(get_figure(run, figure.key("_std")))},
                                      {reference.json, number(hs)},
                                      {"relative_difference", number(difference)},
                                      {"relative_to", relative_to},
                                      {"difference", apart},
                                      {"limit", bound},
                                      {"beyond", beyond}});
        }
      return comparison;
    }

    /// Throws RunError for figures that no run of the scene gives: then the file was changed, and half-spaces
    /// under such loads would take hours.
    void
    check_figures(const Scene &scene, const Summary &run, const std::string &path)
    {
      const auto require = [&](const char *key, const double low, const double high) {
        const double value = get_figure(run, key);
        if (std::isfinite(value) && (value < low || value > high))
          throw RunError("The file \"" + path + "\" holds " + key + text(" = %.6g", value) +
                         ", which no run of its scene gives; compute it again with \"" + own_call() +
                         " run\" and --overwrite.");
      };
      if (!std::isfinite(run.vertical_force) || !std::isfinite(run.longitudinal_force) ||
          !std::isfinite(run.max_pressure))
        throw RunError(
          "The file \"" + path +
          "\" lacks one of vertical_force_N, longitudinal_force_N and max_pressure_Pa: the run did "
          "not get so far that its patch could be compared.");
      const double load = 100 * expected_load(scene);
      require("vertical_force_N", 1e-6 * load, load);
      require("longitudinal_force_N", -load, load);
      require("max_pressure_Pa", 0, 1e12);
      require("relative_lateral_m", -0.02, 0.02);
      require("rail_head_roll_rad", -0.2, 0.2);
      require("wheel_rim_roll_rad", -0.2, 0.2);
    }

    /// The second table: the run against its own wheel and rail, with what they say of themselves; nothing
    /// where their sections cannot be meshed, which is told.
    nlohmann::ordered_json
    compare_bodies(Scene                scene,
                   const SceneGeometry &geometry,
                   const WheelRailLoad &load,
                   Summary             &run,
                   std::ostream        &out)
    {
      scene.halfspace_bodies = ContactBodies::real;
      try
        {
          const WheelRailSolution result = solve_wheel_rail(scene, geometry, load, {});
          Summary                 bodies = halfspace_summary(scene, result);
          set_pose_figures(body_pose(scene, geometry, result), bodies);
          // those of half-spaces under the tractions of the bodies: bending adds little near the patch
          set_stress_below(largest_stress_below(halfspace_stresses(result).slices, scene.cell_size), bodies);
          out << "\nThe same against this wheel and this rail as elastic bodies, nothing fitted"
              << (scene.rail_material.yields() || scene.wheel_material.yields() ? "; they do not yield" : "")
              << "\n";
          nlohmann::ordered_json figures = compare_figures(run, bodies, true_bodies, out).table;
          if (!bodies.finished)
            out << "The solution of the true bodies is not exact: " << bodies.stop_reason << std::endl;
          return {{"converged", bodies.finished}, {"figures", std::move(figures)}};
        }
      catch (const RunError &error)
        {
          out << "note: no comparison with the true bodies: " << error.what() << '\n';
        }
      return {};
    }

    nlohmann::ordered_json
    trust_json(const Measures &measures)
    {
      return {{"peak_difference", number(measures.peak_difference)},
              {"bodies_peak_difference", number(measures.bodies_difference)},
              {"cells_over_shorter_extent", number(measures.cells)},
              {"cells_across_peak", number(measures.cells_across_peak)},
              {"penetration_over_approach", number(measures.penetration)},
              {"force_std_over_load", number(measures.unsteadiness)},
              {"largest_drift", number(measures.drift)},
              {"torque_miss", number(measures.torque_miss)},
              {"turn_across_patch_rad", number(measures.turn)},
              {"pose_effect_on_peak", number(measures.pose_effect)},
              {"max_plastic_strain", number(measures.plastic_strain)},
              {"patches", number(measures.patches)},
              {"penalty_part_of_peak_difference", number(measures.penalty_part())},
              {"mesh_part_of_peak_difference", number(measures.mesh_part())}};
    }
  } // namespace


  int
  run_compare_command(const std::string              &folder,
                      const std::vector<std::string> &sets,
                      const bool                      with_bodies,
                      const bool                      draws,
                      std::ostream                   &out)
  {
    const std::filesystem::path path = folder;
    if (std::filesystem::exists(path / "halfspace.h5") && !std::filesystem::exists(path / "patch.h5"))
      throw InputError(folder +
                       ": half-spaces, which have no run to be compared with; compare needs the "
                       "output folder of a run");
    Summary    run   = read_summary((path / "summary.json").string());
    SceneInput input = read_scene((path / "parameters.prm").string(), sets);
    use_kept_profiles(input.scene, folder);
    if (const double place = get_figure(run, "motion_distance_m"); std::isfinite(place))
      input.scene = scene_on_way(input.scene, place);
    const SceneGeometry geometry = require_touching(input);
    if (input.scene.halfspace_memory_length > 0 || input.scene.halfspace_layer_thickness > 0)
      out << "note: Half-space/Friction memory and Interface layer are left out, since a run has neither\n";
    input.scene.halfspace_memory_length   = 0;
    input.scene.halfspace_layer_thickness = 0;
    input.scene.halfspace_bodies          = ContactBodies::half_spaces;
    const Scene &scene                    = input.scene;
    check_figures(scene, run, (path / "summary.json").string());
    const WheelRailLoad     load      = load_of_run(run);
    const SectionOffsets    offsets   = offsets_of_run(run);
    const WheelRailSolution result    = solve_wheel_rail(scene, geometry, load, offsets);
    const HalfspaceStresses stresses  = halfspace_stresses(result);
    Summary                 halfspace = halfspace_summary(scene, result);
    set_stress_below(largest_stress_below(stresses.slices, scene.cell_size), halfspace);

    out << run.title << "\nMeans of the run against half-spaces on elements of "
        << 1e3 * result.solution.grid.dx << " mm, wheel moved by " << text("%.3f", 1e3 * offsets.lateral)
        << " mm and rail turned by " << text("%.3f", 1e3 * (offsets.wheel_roll - offsets.rail_roll))
        << " mrad to the track centre\n";
    const Comparison       comparison = compare_figures(run, halfspace, half_spaces, out);
    nlohmann::ordered_json bodies =
      with_bodies ? compare_bodies(scene, geometry, load, run, out) : nlohmann::ordered_json();
    Measures measures = measures_of_run(scene, run);
    measures.beyond   = comparison.beyond;
    measure_against(halfspace_pressure(result), scene, run, measures);
    if (!bodies.is_null() && bodies["converged"])
      measures.bodies_difference = get_figure(run, "bodies_relative_difference_max_pressure");
    measures.pose_effect =
      result.solution.peak_pressure / halfspace_pressure(scene, geometry, result.solution.fn, {}).peak - 1;
    const Verdict verdict = judge_run(scene, measures);
    set_verdict(run, verdict);
    const std::string sentence = agreement_sentence(scene, measures, verdict);
    out << '\n' << verdict_line(run) << '\n' << sentence << std::endl;
    if (!halfspace.finished)
      out << "The half-space solution is not exact: " << halfspace.stop_reason << std::endl;

    nlohmann::ordered_json json = {{"title", run.title},
                                   {"program_version", WHEELRAIL_VERSION},
                                   {"element_size_m", result.solution.grid.dx},
                                   {"friction_coefficient", scene.friction.at_rest},
                                   {"lateral_offset_m", offsets.lateral},
                                   {"rail_roll_rad", offsets.rail_roll},
                                   {"wheel_roll_rad", offsets.wheel_roll},
                                   {"halfspace_converged", halfspace.finished},
                                   {"figures", comparison.table},
                                   {"bodies", std::move(bodies)},
                                   {"trust", trust_json(measures)},
                                   {"verdict", verdict_of(run)},
                                   {"doubts", run.doubts},
                                   {"sentence", sentence}};
    replace_file((path / "compare.json").string(),
                 json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n");
    write_halfspace_patches(result, path.string());
    write_halfspace_wear(scene, result, (path / "halfspace_wear.csv").string());
    TickFile slices((path / "halfspace_slices.h5").string(), false, 0);
    append_slices(slices, result.patch.time, result.patch.rolled_distance, stresses.slices);
    write_summary(run, (path / "summary.json").string());
    if (draws)
      draw_results("compare.py", path.string());
    return halfspace.finished ? 0 : 2;
  }
} // namespace wheelrail
