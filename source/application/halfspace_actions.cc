#include <wheelrail/application/command_actions.h>
#include <wheelrail/application/places_command.h>
#include <wheelrail/base/errors.h>
#include <wheelrail/base/format_text.h>
#include <wheelrail/base/left_out.h>
#include <wheelrail/bodies/answering_bodies.h>
#include <wheelrail/bodies/body_contact.h>
#include <wheelrail/bodies/body_pose.h>
#include <wheelrail/bodies/shift_effect.h>
#include <wheelrail/commands/command_scene.h>
#include <wheelrail/commands/halfspace_results.h>
#include <wheelrail/commands/report_script.h>
#include <wheelrail/contactfiles/contact_input.h>
#include <wheelrail/contactfiles/wheel_rail_input.h>
#include <wheelrail/input/cross_checks.h>
#include <wheelrail/input/entries.h>
#include <wheelrail/model/scene_checks.h>
#include <wheelrail/model/scene_geometry.h>
#include <wheelrail/model/section_file.h>
#include <wheelrail/output/folder.h>
#include <wheelrail/output/replace_file.h>
#include <wheelrail/run/end_screen.h>
#include <wheelrail/scene/scene.h>
#include <wheelrail/sections/sections_command.h>
#include <wheelrail/vehicle/creep_curve_command.h>
#include <wheelrail/vehicle/wheelset_command.h>
#include <wheelrail/wheel/given_distance.h>
#include <wheelrail/wheel/halfspace_case.h>
#include <wheelrail/wheel/halfspace_parts.h>
#include <wheelrail/wheel/noise_effect.h>
#include <wheelrail/wheel/several_patches.h>

#include <filesystem>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

namespace wheelrail
{
  namespace
  {
    /// Files to write for the program CONTACT; empty: none.
    struct ContactInputFiles
    {
      std::string basic;      ///< the discrete problem, for the basic module
      std::string wheel_rail; ///< the scene, for the wheel-rail module; two profile files go beside it
    };

    /// The input and, beside it, the profile files: case.inp, case_rail.txt, case_wheel.txt.
    void
    write_wheel_rail_input(const Scene         &scene,
                           const SceneGeometry &geometry,
                           const double         vertical_load,
                           const std::string   &path)
    {
      const std::filesystem::path whole = path;
      const std::string           stem  = whole.stem().string();
      const std::string           rail = stem + "_rail.txt", wheel = stem + "_wheel.txt";
      const WheelRailInput        files = wheel_rail_input(scene, geometry, vertical_load, rail, wheel);
      replace_file((whole.parent_path() / rail).string(), files.rail);
      replace_file((whole.parent_path() / wheel).string(), files.wheel);
      replace_file(path, files.input);
    }

    void
    print_patches(const Summary &figures, const std::size_t n, std::ostream &out)
    {
      out << n
          << " patches, each in its own plane, which differ by more than 6 degrees:\n"
             "  patch  normal force  longitudinal   lateral     angle  across, in the  ahead of the  peak "
             "pressure      area   T-gamma\n"
             "                   kN            kN        kN      mrad      track, mm      axle, mm           "
             "MPa       mm2         N\n";
      for (std::size_t k = 1; k <= n; ++k)
        {
          const auto value = [&](const char *key) { return get_figure(figures, patch_prefix(k) + key); };
          out << text("%7zu %13.3f %13.3f %9.3f %9.2f %14.2f %13.2f %13.1f %9.2f %9.2f\n",
                      k,
                      1e-3 * value("normal_force_N"),
                      1e-3 * value("longitudinal_force_N"),
                      1e-3 * value("tangential_lateral_force_N"),
                      1e3 * value("reference_angle_rad"),
                      1e3 * value("reference_lateral_m"),
                      1e3 * value("reference_ahead_of_axle_m"),
                      1e-6 * value("max_pressure_Pa"),
                      1e6 * value("contact_area_m2"),
                      value("t_gamma_N"));
        }
    }

    /// What of the scene this contact does not see, though a run would.
    void
    print_left_out(const Scene &scene, std::ostream &out)
    {
      if (scene.irregular())
        out << "note: at the start of the path alone, and the irregular surfaces as they are there; --places "
               "goes along the path\n";
      if (scene.support.kind != RailSupport::clamped_foot)
        out << "note: without Track/Support: the contact of steady rolling does not depend on it\n";
    }

    /// What was solved, and its figures. `given`: the undeformed distance, and with it the normal force.
    void
    print_solution(const Scene             &scene,
                   const WheelRailSolution &result,
                   const HalfspaceResults  &results,
                   const bool               given,
                   std::ostream            &out)
    {
      const bool           real    = scene.halfspace_bodies == ContactBodies::real;
      const Summary       &figures = results.figures;
      const HalfspaceGrid &grid    = result.solution.grid;
      out << text("%s: %s %.3f kN, %s, elements of %g mm, grid of %d x %d\n",
                  real ? "Contact of the true bodies" : "Half-space contact",
                  given ? "normal force" : "wheel load",
                  1e-3 * (given ? result.solution.fn : figures.vertical_force),
                  scene.drive == Drive::rate ? "creepage given" : "longitudinal force given",
                  1e3 * grid.dx,
                  grid.mx,
                  grid.my);
      if (const std::string note = resolution_note(scene, result.solution); !note.empty())
        out << "note: " << note << '\n';
      for (const std::string &line : halfspace_screen(figures))
        out << line << '\n';
      if (!result.others.empty())
        print_patches(figures, result.others.size() + 1, out);
      print_stresses(results.stresses, out);
      if (const std::string beside = model_beside(figures); !beside.empty())
        out << beside << '\n';
    }

    /// Solves the scene by its bodies (solve_with_bodies()), prints the figures, and writes halfspace.h5 (one
    /// tick in the form of a run's patch.h5), slices.h5 (stresses below the contact, as a run's),
    /// summary.json, parameters.prm and pictures into "<Output/Folder>-halfspace". Pictures are left out
    /// unless `draws`. Where file names are given, also writes inputs for the program CONTACT. `geometry` may
    /// be null unless needs_profiles(). Returns the exit code. Throws InputError, RunError.
    int
    run_halfspace_command(Scene                    scene,
                          const SceneGeometry     *geometry,
                          const ContactInputFiles &inputs,
                          const bool               draws,
                          std::ostream            &out)
    {
      const ResultFolder           held(scene.folder, "-halfspace");
      const std::filesystem::path &folder = held.path();
      const bool                   given  = distance_is_given(scene);
      const WheelRailLoad          load   = given ? WheelRailLoad() : scene_load(scene, *geometry);
      print_head(scene, load.force, out);
      if (!given)
        print_left_out(scene, out);
      WheelRailSolution result;
      const std::string why = solve_with_bodies(scene, [&]() {
        result = given ? solve_given_distance(scene, geometry)
                       : solve_wheel_rail(scene, *geometry, load, scene_offsets(scene));
      });
      print_notes(result.notes, out);
      const bool real = scene.halfspace_bodies == ContactBodies::real;
      if (!given)
        {
          hold_against_bodies(scene, *geometry, result);
          find_noise_effect(scene, *geometry, result);
        }
      HalfspaceResults results = halfspace_results(scene, result);
      if (!why.empty())
        results.figures.note = why;
      if (real)
        {
          set_pose_figures(body_pose(scene, *geometry, result), results.figures);
          add_halfspaces(scene, *geometry, load, results.figures);
        }
      const Summary &figures = results.figures;
      if (!inputs.basic.empty())
        replace_file(inputs.basic, contact_input(result.problem, scene.title));
      if (!inputs.wheel_rail.empty())
        write_wheel_rail_input(scene, *geometry, figures.vertical_force, inputs.wheel_rail);
      print_solution(scene, result, results, given, out);

      remove_earlier_results(folder);
      write_halfspace_folder(scene, result, results, folder.string());
      if (!given)
        write_sections(*geometry, scene.track, (folder / "sections.json").string());
      out << "Results in " << folder.string() << ", all results in its summary.json" << std::endl;
      if (draws)
        draw_results("halfspace.py", folder.string());
      return figures.finished ? 0 : 2;
    }

    int
    halfspaces_of_wheelset(const po::variables_map        &options,
                           SceneInput                     &input,
                           const std::vector<std::string> &warnings,
                           std::ostream                   &out)
    {
      for (const char *option :
           {"contact-input", "contact-wheel-rail-input", "creep-curve", "places", "pitch"})
        if (options.count(option))
          throw InputError(std::string("--") + option + " takes one wheel; " +
                           entry_text(input.scene, "Wheelset", "Wheels") + " asks for two: set it to one");
      for (const std::string &warning : warnings)
        out << "warning: " << warning << "\n";
      print_note(drive_note(options, input), out);
      settle_bodies(input.scene, "", out);
      return run_wheelset_command(input.scene, !options.count("no-pictures"), out);
    }

    /// What true bodies do not have: irregular surfaces, one spin for the whole contact, and a problem that
    /// CONTACT could solve. Throws InputError where they are asked for; else the scene is left to
    /// half-spaces.
    void
    leave_to_half_spaces(const po::variables_map &options, Scene &scene, std::ostream &out)
    {
      const auto  curve = options.count("creep-curve") ? options["creep-curve"].as<std::string>() : "";
      std::string why;
      for (const std::string option : {"places", "pitch"})
        if (options.count(option))
          why = "--" + option + " puts the wheel on irregular half-spaces";
      if (curve.rfind("spin", 0) == 0)
        why =
          "--creep-curve \"spin ...\" gives the whole contact one spin, which bodies of their own shape do "
          "not have";
      if (options.count("contact-input"))
        why = "--contact-input writes the problem of two half-spaces";
      if (!why.empty() && scene.halfspace_bodies == ContactBodies::real)
        throw InputError(entry_text(scene, "Half-space", "Bodies") + ": " + why +
                         "; write half-spaces there");
      if (why.empty() && !curve.empty())
        why = "as creep curves are; --bodies real takes true bodies, a second a point";
      settle_bodies(scene, why, out);
    }

    int
    halfspaces_of_places(const po::variables_map &options,
                         const Scene             &scene,
                         const SceneGeometry     *geometry,
                         std::ostream            &out)
    {
      if (options.count("places") + options.count("pitch") + options.count("creep-curve") > 1)
        throw InputError("--places, --pitch and --creep-curve are different tables: give one of them");
      const bool        pitch  = options.count("pitch") > 0;
      const std::string option = pitch ? "pitch" : "places";
      if (distance_is_given(scene))
        throw InputError(entry_text(scene, "Half-space", "Undeformed distance") + ": --" + option +
                         " needs wheel and rail; set it to profiles");
      return run_places_command(scene,
                                *geometry,
                                parse_irregular_places(options[option].as<std::string>(), pitch),
                                !options.count("no-pictures"),
                                out);
    }
  } // namespace


  int
  act_halfspace(const po::variables_map &options, const RunFunction &, std::ostream &out)
  {
    require_file(options, "halfspace");
    const auto file = [&](const char *option) {
      return options.count(option) ? options[option].as<std::string>() : std::string();
    };
    if (!file("beside").empty() && file("creep-curve").empty())
      throw InputError("--beside draws points beside a creep curve: give --creep-curve, too");
    for (const char *const option : {"contact-input", "contact-wheel-rail-input"})
      if (options.count(option) && !is_built(Subject::contact_files))
        refuse_left_out(std::string("--") + option, Subject::contact_files);
    SceneInput     input = one_scene_of(options);
    const Findings found = contact_checks(input.scene);
    require_none(found.errors, input);
    print_notes(idle_entries(options, input, "halfspace"), out);
    if (input.scene.rail_by_slices())
      {
        if (file("places").empty() || input.scene.both_wheels)
          throw InputError("Profiles/Rail = " + input.scene.rail_profile +
                           ": of slices along the track halfspace takes one wheel at places: give --places "
                           "\"0:600:20 mm\"");
        return run_sections_command(input.scene, file("places"), !options.count("no-pictures"), out);
      }
    if (input.scene.both_wheels)
      return halfspaces_of_wheelset(options, input, found.warnings, out);
    leave_to_half_spaces(options, input.scene, out);
    std::optional<SceneGeometry> geometry;
    if (needs_profiles(input.scene) || !file("contact-wheel-rail-input").empty())
      geometry = require_touching(input);
    if (geometry)
      print_notes(geometry->notes, out);
    for (const std::string &warning : found.warnings)
      out << "warning: " << warning << "\n";
    if (file("creep-curve").rfind("longitudinal", 0) != 0) // which runs over what drives
      print_note(drive_note(options, input), out);
    if (!file("places").empty() || !file("pitch").empty())
      return halfspaces_of_places(options, input.scene, geometry ? &*geometry : nullptr, out);
    if (!file("creep-curve").empty())
      return run_creep_curve_command(input.scene,
                                     geometry ? &*geometry : nullptr,
                                     parse_creep_curve(file("creep-curve")),
                                     file("beside"),
                                     !options.count("no-pictures"),
                                     out);
    return run_halfspace_command(input.scene,
                                 geometry ? &*geometry : nullptr,
                                 {file("contact-input"), file("contact-wheel-rail-input")},
                                 !options.count("no-pictures"),
                                 out);
  }
} // namespace wheelrail
