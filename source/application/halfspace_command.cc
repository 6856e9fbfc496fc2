#include <wheelrail/application/halfspace_command.h>
#include <wheelrail/application/report_script.h>
#include <wheelrail/base/errors.h>
#include <wheelrail/input/listing.h>
#include <wheelrail/output/folder.h>
#include <wheelrail/output/hdf5_file.h>
#include <wheelrail/output/replace_file.h>
#include <wheelrail/reference/contact_input.h>
#include <wheelrail/reference/given_distance.h>
#include <wheelrail/reference/halfspace_case.h>
#include <wheelrail/reference/halfspace_parts.h>
#include <wheelrail/reference/halfspace_stresses.h>
#include <wheelrail/reference/wheel_rail_input.h>

#include <cmath>
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
  } // namespace


  int
  run_halfspace_command(const Scene             &scene,
                        const SceneGeometry     *geometry,
                        const ContactInputFiles &inputs,
                        const bool               draws,
                        std::ostream            &out)
  {
    const bool              given = distance_is_given(scene);
    const WheelRailSolution result =
      given ? solve_given_distance(scene, geometry)
            : solve_wheel_rail(scene, *geometry, scene_load(scene, *geometry), scene_offsets(scene));
    if (!inputs.basic.empty())
      replace_file(inputs.basic, contact_input(result.problem, scene.title));
    if (!inputs.wheel_rail.empty())
      write_wheel_rail_input(scene, *geometry, result.vertical, inputs.wheel_rail);
    const HalfspaceStresses stresses = halfspace_stresses(result);
    const HalfspaceGrid    &grid     = result.solution.grid;
    Summary                 figures  = halfspace_summary(scene, result);
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
                  1e-3 * (given ? result.solution.fn : result.vertical),
                  scene.drive == Drive::rate ? "creepage given" : "longitudinal force given",
                  1e3 * grid.dx,
                  grid.mx,
                  grid.my);
    out << text;
    if (const std::string note = resolution_note(scene, result.solution); !note.empty())
      out << "note: " << note << '\n';
    print_summary(figures, out);
    print_stresses(stresses, out);

    const std::filesystem::path folder = folder_beside(scene.folder, "-halfspace");
    replace_file((folder / "parameters.prm").string(), print_parameters(scene));
    TickFile patches((folder / "halfspace.h5").string(), false, 0);
    append_patch(patches, result.patch);
    TickFile slices((folder / "slices.h5").string(), false, 0);
    append_slices(slices, result.patch.time, result.patch.rolled_distance, stresses.slices);
    write_summary(figures, (folder / "summary.json").string());
    out << "Results in " << folder.string() << std::endl;
    if (draws)
      run_script("halfspace.py", {folder.string()});
    return figures.finished ? 0 : 2;
  }
} // namespace wheelrail
