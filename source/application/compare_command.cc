#include <wheelrail/application/compare_command.h>
#include <wheelrail/application/compared_figures.h>
#include <wheelrail/base/errors.h>
#include <wheelrail/base/format_text.h>
#include <wheelrail/base/hints.h>
#include <wheelrail/bodies/body_contact.h>
#include <wheelrail/bodies/body_pose.h>
#include <wheelrail/bodies/run_intervals.h>
#include <wheelrail/bodies/run_reference.h>
#include <wheelrail/commands/command_scene.h>
#include <wheelrail/commands/halfspace_results.h>
#include <wheelrail/commands/report_script.h>
#include <wheelrail/input/without_effect.h>
#include <wheelrail/model/expected_patch.h>
#include <wheelrail/model/profile_copies.h>
#include <wheelrail/model/scene_checks.h>
#include <wheelrail/model/scene_geometry.h>
#include <wheelrail/model/scene_motion.h>
#include <wheelrail/output/figures.h>
#include <wheelrail/output/folder_lock.h>
#include <wheelrail/output/replace_file.h>
#include <wheelrail/sampling/stress_below.h>
#include <wheelrail/verdict/agreement.h>
#include <wheelrail/verdict/verdict.h>
#include <wheelrail/wheel/coarse_halfspaces.h>
#include <wheelrail/wheel/halfspace_stresses.h>

#include <nlohmann/json.hpp>

#include <cmath>
#include <filesystem>

namespace wheelrail
{
  namespace
  {
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
      if (measures_of_run(scene, run).off_rail())
        throw RunError(
          "The file \"" + path +
          "\" holds means of a wheel off the rail, which has no patch to be compared; compute it "
          "again with Run/Evaluate at = largest force.");
      if (const double patches = get_figure(run, "patches");
          patches > 1 && std::isfinite(get_figure(run, "second_rail_force_N")))
        throw RunError(
          "The file \"" + path + "\" holds " + text("%g", patches) +
          " separate patches on two rails beside each other, which compare takes for one; half-spaces "
          "at each place of these rails: \"" +
          own_call() + " halfspace FILE.prm --places\".");
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
      return {{"peak_difference", json_number(measures.peak_difference)},
              {"bodies_peak_difference", json_number(measures.bodies_difference)},
              {"cells_over_shorter_extent", json_number(measures.cells)},
              {"cells_across_peak", json_number(measures.cells_across_peak)},
              {"penetration_over_approach", json_number(measures.penetration)},
              {"force_std_over_load", json_number(measures.unsteadiness)},
              {"largest_drift", json_number(measures.drift)},
              {"torque_miss", json_number(measures.torque_miss)},
              {"turn_across_patch_rad", json_number(measures.turn)},
              {"pose_effect_on_peak", json_number(measures.pose_effect)},
              {"max_plastic_strain", json_number(measures.plastic_strain)},
              {"patches", json_number(measures.patches)},
              {"penalty_part_of_peak_difference", json_number(measures.penalty_part())},
              {"mesh_part_of_peak_difference", json_number(measures.mesh_part())}};
    }

    /// Throws InputError where the folder holds no results of a run.
    void
    require_run(const std::string &folder)
    {
      const std::filesystem::path path = folder;
      const auto holds   = [&](const char *name) { return std::filesystem::exists(path / name); };
      const auto refusal = [&](const std::string &why) {
        return InputError(folder + ": " + why + "; compare needs the output folder of a run");
      };
      if ((holds("halfspace.h5") && !holds("patch.h5")) || holds("wheelset.csv"))
        throw refusal("half-spaces, which have no run to be compared with");
      for (const char *other :
           {"receptance.csv", "cycles.csv", "wear.json", "vehicle.csv", "cases.csv", "wheel_rail.csv"})
        if (holds(other) && !holds("patch.h5"))
          throw refusal(std::string(other) + " is there, which no run leaves");
      if (!std::filesystem::exists(path / "summary.json"))
        throw InputError("The folder " + folder + " holds no summary.json; give the output folder of a run.");
    }

    /// What is held against half-spaces on elements of `element` mm, and in which pose.
    void
    print_compared(const std::string    &title,
                   const double          element,
                   const SectionOffsets &offsets,
                   std::ostream         &out)
    {
      out << title << "\nMeans of the run against half-spaces on elements of " << element
          << " mm, wheel moved by " << text("%.3f", 1e3 * offsets.lateral) << " mm and rail turned by "
          << text("%.3f", 1e3 * (offsets.wheel_roll - offsets.rail_roll)) << " mrad to the track centre\n";
    }

    /// What the verdict of a compared run follows from. `bodies`: what compare_bodies() gave.
    Measures
    measures_of_comparison(const Scene                  &scene,
                           const SceneGeometry          &geometry,
                           const Summary                &run,
                           const WheelRailSolution      &result,
                           const Comparison             &comparison,
                           const bool                    with_bodies,
                           const nlohmann::ordered_json &bodies)
    {
      Measures measures      = measures_of_run(scene, run);
      measures.beyond        = comparison.beyond;
      measures.expected_loss = expected_loss(scene, expected_patch(scene, geometry));
      measures.creep         = known_creep_of_run(scene, run);
      measure_against(halfspace_pressure(result), scene, run, measures);
      if (with_bodies && force_is_a_result(scene))
        measure_against_bodies(scene, geometry, run, measures);
      if (!bodies.is_null() && bodies["converged"])
        measures.bodies_difference = get_figure(run, "bodies_relative_difference_max_pressure");
      measures.pose_effect =
        result.solution.peak_pressure / halfspace_pressure(scene, geometry, result.solution.fn, {}).peak - 1;
      return measures;
    }
  } // namespace


  int
  run_compare_command(const std::string              &folder,
                      const std::vector<std::string> &sets,
                      const bool                      with_bodies,
                      const bool                      draws,
                      std::ostream                   &out)
  {
    require_run(folder);
    const std::filesystem::path path = folder;
    const FolderLock            held(folder); // no run, and no other comparison, works in it meanwhile
    Summary                     run   = read_summary((path / "summary.json").string());
    SceneInput                  input = read_scene((path / "parameters.prm").string(), sets);
    print_notes(entries_without_effect(input, "compare"), out);
    use_kept_profiles(input.scene, folder);
    if (const double place = get_figure(run, "motion_distance_m"); std::isfinite(place))
      input.scene = scene_on_path(input.scene, place);
    const SceneGeometry geometry = require_touching(input);
    input.scene                  = scene_of_run(input.scene);
    input.scene.halfspace_bodies = ContactBodies::half_spaces;
    const Scene &scene           = input.scene;
    check_figures(scene, run, (path / "summary.json").string());
    const WheelRailLoad     load      = load_of_run(run);
    const SectionOffsets    offsets   = offsets_of_run(run);
    const WheelRailSolution result    = solve_wheel_rail(scene, geometry, load, offsets);
    const HalfspaceStresses stresses  = halfspace_stresses(result);
    Summary                 halfspace = halfspace_summary(scene, result);
    set_stress_below(largest_stress_below(stresses.slices, scene.cell_size), halfspace);

    print_compared(run.title, 1e3 * result.solution.grid.dx, offsets, out);
    const Comparison       comparison = compare_figures(run, halfspace, half_spaces, out);
    nlohmann::ordered_json bodies =
      with_bodies ? compare_bodies(scene, geometry, load, run, out) : nlohmann::ordered_json();
    const Measures measures =
      measures_of_comparison(scene, geometry, run, result, comparison, with_bodies, bodies);
    const Verdict verdict = judge_run(scene, measures);
    set_verdict(run, verdict);
    const std::string sentence = agreement_sentence(scene, measures, verdict);
    out << '\n' << verdict_line(run) << '\n' << sentence << std::endl;
    if (!halfspace.finished)
      out << "The half-space solution is not exact: " << halfspace.stop_reason << std::endl;

    nlohmann::ordered_json json = {{"title", run.title},
                                   {"program_version", WHEELRAIL_VERSION},
                                   {"element_size_m", result.solution.grid.dx},
                                   {"friction_coefficient", scene.friction.at(0)},
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
