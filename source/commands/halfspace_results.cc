#include <wheelrail/base/format_text.h>
#include <wheelrail/commands/halfspace_results.h>
#include <wheelrail/input/listing.h>
#include <wheelrail/model/scene_head.h>
#include <wheelrail/output/hdf5_file.h>
#include <wheelrail/output/replace_file.h>
#include <wheelrail/wheel/halfspace_parts.h>

#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <iomanip>

namespace wheelrail
{
  void
  print_head(const Scene &scene, const double wheel_load, std::ostream &out)
  {
    for (const HeadLine &line : scene_head(scene, wheel_load, HeadOf::halfspaces))
      out << "  " << std::left << std::setw(16) << line.name << line.text << '\n';
    out << std::right << std::flush;
  }


  HalfspaceResults
  halfspace_results(const Scene &scene, const WheelRailSolution &solution)
  {
    HalfspaceResults results;
    results.figures                   = halfspace_summary(scene, solution, &results.contributions);
    results.stresses                  = halfspace_stresses(solution);
    const HalfspaceStresses &stresses = results.stresses;
    set_figure(results.figures, "surface_von_mises_Pa", stresses.surface_von_mises);
    if (stresses.subsurface_von_mises > 0)
      {
        set_figure(results.figures, "subsurface_von_mises_Pa", stresses.subsurface_von_mises);
        set_figure(results.figures, "subsurface_von_mises_depth_m", stresses.subsurface_depth);
      }
    return results;
  }


  void
  print_stresses(const HalfspaceStresses &stresses, std::ostream &out)
  {
    if (stresses.subsurface_von_mises > 0)
      out << text(
        "Largest von Mises stress: %.1f MPa %.2f mm below the surface, in the %s; %.1f MPa at "
        "the surface\n",
        1e-6 * stresses.subsurface_von_mises,
        1e3 * stresses.subsurface_depth,
        stresses.subsurface_body == Body::rail ? "rail" : "wheel",
        1e-6 * stresses.surface_von_mises);
    else
      out << text("Largest von Mises stress: %.1f MPa at the surface, from which it falls everywhere\n",
                  1e-6 * stresses.surface_von_mises);
  }


  void
  write_halfspace_patches(const WheelRailSolution &solution, const std::string &folder)
  {
    const std::filesystem::path path = folder;
    TickFile                    file((path / "halfspace.h5").string(), false, 0);
    append_patch(file, solution.patch);
    const auto other_file = [&](const std::size_t number) {
      return path / ("halfspace_patch_" + std::to_string(number) + ".h5");
    };
    for (std::size_t k = 0; k < solution.others.size(); ++k)
      {
        TickFile other(other_file(k + 2).string(), false, 0);
        append_patch(other, solution.others[k].patch);
      }
    // of an earlier solution with more patches
    for (std::size_t k = solution.others.size() + 2; std::filesystem::remove(other_file(k)); ++k)
      ;
  }


  void
  write_halfspace_wear(const Scene &scene, const WheelRailSolution &solution, const std::string &path)
  {
    FigureTable  table     = empty_wear_table();
    unsigned int number    = 0;
    const auto   add_patch = [&](const WheelRailSolution &patch) {
      add_to_table(
        halfspace_wear(patch.problem, patch.solution, scene.velocity, scene.wear), ++number, table);
    };
    add_patch(solution);
    for (const WheelRailSolution &other : solution.others)
      add_patch(other);
    table.write_csv(path);
  }


  void
  write_halfspace_folder(const Scene             &scene,
                         const WheelRailSolution &solution,
                         const HalfspaceResults  &results,
                         const std::string       &folder)
  {
    const std::filesystem::path path = folder;
    replace_file((path / "parameters.prm").string(), print_parameters(scene));
    write_halfspace_patches(solution, folder);
    TickFile slices((path / "slices.h5").string(), false, 0);
    append_slices(slices, solution.patch.time, solution.patch.rolled_distance, results.stresses.slices);
    write_halfspace_wear(scene, solution, (path / "wear.csv").string());
    replace_file((path / "intervals.csv").string(), contributions_as_csv(results.contributions));
    write_summary(results.figures, (path / "summary.json").string());
  }
} // namespace wheelrail
