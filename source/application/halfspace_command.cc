#include <wheelrail/application/halfspace_command.h>
#include <wheelrail/base/errors.h>
#include <wheelrail/bodies/answering_bodies.h>
#include <wheelrail/bodies/body_contact.h>
#include <wheelrail/bodies/body_pose.h>
#include <wheelrail/bodies/shift_effect.h>
#include <wheelrail/commands/command_scene.h>
#include <wheelrail/commands/halfspace_results.h>
#include <wheelrail/commands/report_script.h>
#include <wheelrail/contactfiles/contact_input.h>
#include <wheelrail/contactfiles/wheel_rail_input.h>
#include <wheelrail/model/section_file.h>
#include <wheelrail/output/folder.h>
#include <wheelrail/output/replace_file.h>
#include <wheelrail/run/end_screen.h>
#include <wheelrail/wheel/given_distance.h>
#include <wheelrail/wheel/halfspace_case.h>
#include <wheelrail/wheel/halfspace_parts.h>
#include <wheelrail/wheel/noise_effect.h>
#include <wheelrail/wheel/several_patches.h>

#include <cstdio>
#include <filesystem>

namespace wheelrail
{
  namespace
  {
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
      char line[200];
      for (std::size_t k = 1; k <= n; ++k)
        {
          const auto value = [&](const char *key) { return get_figure(figures, patch_prefix(k) + key); };
          std::snprintf(line,
                        sizeof(line),
                        "%7zu %13.3f %13.3f %9.3f %9.2f %14.2f %13.2f %13.1f %9.2f %9.2f\n",
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
          out << line;
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
      char                 text[256];
      std::snprintf(text,
                    sizeof(text),
                    "%s: %s %.3f kN, %s, elements of %g mm, grid of %d x %d\n",
                    real ? "Contact of the true bodies" : "Half-space contact",
                    given ? "normal force" : "wheel load",
                    1e-3 * (given ? result.solution.fn : figures.vertical_force),
                    scene.drive == Drive::rate ? "creepage given" : "longitudinal force given",
                    1e3 * grid.dx,
                    grid.mx,
                    grid.my);
      out << text;
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
  } // namespace


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
} // namespace wheelrail
