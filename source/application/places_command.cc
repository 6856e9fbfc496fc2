#include <wheelrail/application/places_command.h>
#include <wheelrail/base/format_text.h>
#include <wheelrail/base/progress.h>
#include <wheelrail/bodies/body_contact.h>
#include <wheelrail/bodies/shift_effect.h>
#include <wheelrail/commands/halfspace_results.h>
#include <wheelrail/commands/report_script.h>
#include <wheelrail/commands/row_verdicts.h>
#include <wheelrail/input/listing.h>
#include <wheelrail/output/figure_table.h>
#include <wheelrail/output/folder.h>
#include <wheelrail/output/hdf5_file.h>
#include <wheelrail/output/replace_file.h>
#include <wheelrail/output/tick_file.h>
#include <wheelrail/verdict/rules.h>
#include <wheelrail/wheel/contact_intervals.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace wheelrail
{
  namespace
  {
    void
    print_table(const IrregularPlaces &places, const std::vector<PlaceContact> &contacts, std::ostream &out)
    {
      out << "Wheel at rest " << (places.pitch ? "at pitch angles" : "at places along the track")
          << "; its drop is measured from its height on the smooth rail\n\n";
      out << (places.pitch ? "     pitch" : "     place")
          << "         peak        area  patches    width   length      ahead       drop slope force\n"
          << (places.pitch ? "       deg" : "        mm")
          << "          MPa         mm2                mm       mm         mm         um          N\n";
      for (std::size_t k = 0; k < contacts.size(); ++k)
        {
          const PlaceContact &c = contacts[k];
          out << text("%10.3f %12.1f %11.2f %8d %8.2f %8.2f %10.2f %10.2f %10.1f\n",
                      places.pitch ? c.pitch * 180 / M_PI : 1e3 * c.place,
                      1e-6 * c.peak_pressure,
                      1e6 * c.area,
                      c.patches,
                      1e3 * c.width,
                      1e3 * c.length,
                      1e3 * c.centre_along,
                      1e6 * c.drop,
                      c.slope_force);
        }
    }

    /// Half-spaces of the smooth contact beside the true bodies, which know no irregular surfaces: places are
    /// trusted no more.
    struct SmoothContact
    {
      Verdict verdict;
      double  bodies_effect; ///< peak pressure over that of the true bodies, less 1; NaN: unknown
    };

    SmoothContact
    judge_smooth_contact(const Scene &scene, SceneGeometry smooth, const double force)
    {
      smooth.surfaces.rail.set_irregularities(nullptr);
      smooth.surfaces.wheel.set_irregularities(nullptr);
      WheelRailLoad load;
      load.force               = force;
      load.vertical            = true;
      WheelRailSolution result = solve_wheel_rail(scene, smooth, load, scene_offsets(scene));
      hold_against_bodies(scene, smooth, result);
      Measures measures;
      measures.bodies_effect = result.bodies_effect;
      measures.peak =
        known_within("max_pressure", result.solution.peak_pressure, 1, element_contributions(result));
      measures.shift_effect = result.shift_effect;
      measures.unheld       = result.unheld;
      Verdict verdict;
      judge_held(measures, verdict, false);
      return {verdict, result.bodies_effect};
    }

    Grade
    grade_of_place(const PlaceContact &contact, const SmoothContact &smooth)
    {
      return contact.fault.empty() ? std::min(contact.verdict.grade(), smooth.verdict.grade())
                                   : Grade::not_trusted;
    }

    /// Returns the number of places that could not be solved.
    std::size_t
    print_verdicts(const IrregularPlaces           &places,
                   const std::vector<PlaceContact> &contacts,
                   const SmoothContact             &smooth,
                   std::ostream                    &out)
    {
      std::size_t             faults = 0;
      std::vector<RowVerdict> verdicts;
      for (const PlaceContact &c : contacts)
        {
          faults += c.fault.empty() ? 0 : 1;
          verdicts.push_back(
            {places.pitch ? text("pitch %g deg", c.pitch * 180 / M_PI) : text("place %g mm", 1e3 * c.place),
             grade_of_place(c, smooth),
             c.fault.empty() ? c.verdict.doubts() : c.fault});
        }
      print_row_verdicts(verdicts, places.pitch ? "pitch angles" : "places", "verdict of places.csv", out);
      if (std::isfinite(smooth.bodies_effect))
        out << text(
          "on the smooth rail the peak pressure of half-spaces is %+.1f %% beside that of the true bodies\n",
          100 * smooth.bodies_effect);
      if (!smooth.verdict.findings.empty())
        out << "on the smooth rail: " << smooth.verdict.doubts() << '\n';
      return faults;
    }

    FigureTable
    table_of(const std::vector<PlaceContact> &contacts, const SmoothContact &smooth)
    {
      FigureTable table;
      const auto  column = [&](const char *key, const char *unit, const auto &value) {
        std::vector<double> values;
        for (const PlaceContact &c : contacts)
          values.push_back(value(c));
        table.add(key, unit, values);
      };
      using C = const PlaceContact &;
      column("place_m", "m", [](C c) { return c.place; });
      column("pitch_rad", "rad", [](C c) { return c.pitch; });
      column("max_pressure_Pa", "Pa", [](C c) { return c.peak_pressure; });
      column("area_of_whole_elements_m2", "m2", [](C c) { return c.area; });
      column("separate_patches", "1", [](C c) { return c.patches; });
      column("patch_width_m", "m", [](C c) { return c.width; });
      column("patch_length_m", "m", [](C c) { return c.length; });
      column("centre_of_pressure_ahead_m", "m", [](C c) { return c.centre_along; });
      column("centre_of_pressure_lateral_m", "m", [](C c) { return c.centre_lateral; });
      column("approach_m", "m", [](C c) { return c.approach; });
      column("wheel_drop_m", "m", [](C c) { return c.drop; });
      column("normal_force_N", "N", [](C c) { return c.normal_force; });
      column("slope_force_N", "N", [](C c) { return c.slope_force; });
      column("verdict", "1", [&](C c) { return static_cast<double>(grade_of_place(c, smooth)); });
      return table;
    }

    void
    write_patches(const std::vector<PlaceContact> &contacts, const std::string &path)
    {
      TickFile file(path, false, 0);
      for (const PlaceContact &c : contacts)
        append_patch(file, c.patch);
    }
  } // namespace


  int
  run_places_command(const Scene           &scene,
                     const SceneGeometry   &geometry,
                     const IrregularPlaces &places,
                     const bool             draws,
                     std::ostream          &out)
  {
    const ResultFolder           held(scene.folder, "-halfspace");
    const std::filesystem::path &folder = held.path();
    const double                 load   = scene_load(scene, geometry).force;
    print_head(scene, load, out);
    TaskCount                       count("places", places.values.size(), 0, out);
    const std::vector<PlaceContact> contacts = solve_places(scene, geometry, load, places, &count);
    const SmoothContact             smooth   = judge_smooth_contact(scene, geometry, load);
    print_table(places, contacts, out);
    const std::size_t failed = print_verdicts(places, contacts, smooth, out);

    replace_file((folder / "parameters.prm").string(), print_parameters(scene));
    const FigureTable table = table_of(contacts, smooth);
    table.write_csv((folder / "places.csv").string());
    write_patches(contacts, (folder / "places.h5").string());
    out << "Table in " << (folder / "places.csv").string() << std::endl;
    if (draws)
      draw_results("places.py", folder.string());
    return failed == 0 ? 0 : 2;
  }
} // namespace wheelrail
