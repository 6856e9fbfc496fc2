#include <wheelrail/application/halfspace_command.h>
#include <wheelrail/application/report_script.h>
#include <wheelrail/base/errors.h>
#include <wheelrail/input/listing.h>
#include <wheelrail/model/scene_head.h>
#include <wheelrail/output/folder.h>
#include <wheelrail/output/hdf5_file.h>
#include <wheelrail/output/replace_file.h>
#include <wheelrail/reference/contact_input.h>
#include <wheelrail/reference/given_distance.h>
#include <wheelrail/reference/halfspace_case.h>
#include <wheelrail/reference/halfspace_parts.h>
#include <wheelrail/reference/halfspace_stresses.h>
#include <wheelrail/reference/several_patches.h>
#include <wheelrail/reference/wheel_rail_input.h>

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <iomanip>

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
    print_head(const Scene &scene, const double wheel_load, std::ostream &out)
    {
      for (const HeadLine &line : scene_head(scene, wheel_load, HeadOf::halfspaces))
        out << "  " << std::left << std::setw(16) << line.name << line.text << '\n';
      out << std::right << std::flush;
    }

    void
    print_stresses(const HalfspaceStresses &stresses, std::ostream &out)
    {
      char text[256];
      if (stresses.subsurface_von_mises > 0)
        std::snprintf(text,
                      sizeof(text),
                      "Largest von Mises stress: %.1f MPa %.2f mm below the surface, in the %s; %.1f MPa at "
                      "the surface\n",
                      1e-6 * stresses.subsurface_von_mises,
                      1e3 * stresses.subsurface_depth,
                      stresses.subsurface_body == Body::rail ? "rail" : "wheel",
                      1e-6 * stresses.surface_von_mises);
      else
        std::snprintf(text,
                      sizeof(text),
                      "Largest von Mises stress: %.1f MPa at the surface, from which it falls everywhere\n",
                      1e-6 * stresses.surface_von_mises);
      out << text;
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
  } // namespace


  void
  write_halfspace_patches(const WheelRailSolution &result, const std::string &folder)
  {
    const std::filesystem::path path = folder;
    TickFile                    file((path / "halfspace.h5").string(), false, 0);
    append_patch(file, result.patch);
    const auto other_file = [&](const std::size_t number) {
      return path / ("halfspace_patch_" + std::to_string(number) + ".h5");
    };
    for (std::size_t k = 0; k < result.others.size(); ++k)
      {
        TickFile other(other_file(k + 2).string(), false, 0);
        append_patch(other, result.others[k].patch);
      }
    // of an earlier solution with more patches
    for (std::size_t k = result.others.size() + 2; std::filesystem::remove(other_file(k)); ++k)
      ;
  }


  int
  run_halfspace_command(const Scene             &scene,
                        const SceneGeometry     *geometry,
                        const ContactInputFiles &inputs,
                        const bool               draws,
                        std::ostream            &out)
  {
    const bool          given = distance_is_given(scene);
    const WheelRailLoad load  = given ? WheelRailLoad() : scene_load(scene, *geometry);
    print_head(scene, load.force, out);
    const WheelRailSolution result  = given ? solve_given_distance(scene, geometry)
                                            : solve_wheel_rail(scene, *geometry, load, scene_offsets(scene));
    Summary                 figures = halfspace_summary(scene, result);
    if (!inputs.basic.empty())
      replace_file(inputs.basic, contact_input(result.problem, scene.title));
    if (!inputs.wheel_rail.empty())
      write_wheel_rail_input(scene, *geometry, figures.vertical_force, inputs.wheel_rail);
    const HalfspaceStresses stresses = halfspace_stresses(result);
    const HalfspaceGrid    &grid     = result.solution.grid;
    set_figure(figures, "surface_von_mises_Pa", stresses.surface_von_mises);
    if (stresses.subsurface_von_mises > 0)
      {
        set_figure(figures, "subsurface_von_mises_Pa", stresses.subsurface_von_mises);
        set_figure(figures, "subsurface_von_mises_depth_m", stresses.subsurface_depth);
      }

    char text[256];
    std::snprintf(text,
                  sizeof(text),
                  "Half-space contact: %s %.3f kN, %s, elements of %g mm, grid of %d x %d\n",
                  given ? "normal force" : "wheel load",
                  1e-3 * (given ? result.solution.fn : figures.vertical_force),
                  scene.drive == Drive::rate ? "creepage given" : "longitudinal force given",
                  1e3 * grid.dx,
                  grid.mx,
                  grid.my);
    out << text;
    if (const std::string note = resolution_note(scene, result.solution); !note.empty())
      out << "note: " << note << '\n';
    print_summary(figures, out);
    if (!result.others.empty())
      print_patches(figures, result.others.size() + 1, out);
    print_stresses(stresses, out);

    const std::filesystem::path folder = folder_beside(scene.folder, "-halfspace");
    replace_file((folder / "parameters.prm").string(), print_parameters(scene));
    write_halfspace_patches(result, folder.string());
    TickFile slices((folder / "slices.h5").string(), false, 0);
    append_slices(slices, result.patch.time, result.patch.rolled_distance, stresses.slices);
    write_summary(figures, (folder / "summary.json").string());
    out << "Results in " << folder.string() << std::endl;
    if (draws)
      draw_results("halfspace.py", folder.string());
    return figures.finished ? 0 : 2;
  }
} // namespace wheelrail
