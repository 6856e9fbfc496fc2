#include <wheelrail/base/errors.h>
#include <wheelrail/base/format_text.h>
#include <wheelrail/base/parallel.h>
#include <wheelrail/base/progress.h>
#include <wheelrail/base/quantity.h>
#include <wheelrail/commands/command_scene.h>
#include <wheelrail/commands/halfspace_results.h>
#include <wheelrail/commands/report_script.h>
#include <wheelrail/input/listing.h>
#include <wheelrail/model/scene_geometry.h>
#include <wheelrail/output/figure_table.h>
#include <wheelrail/output/folder.h>
#include <wheelrail/output/replace_file.h>
#include <wheelrail/sections/rail_slices.h>
#include <wheelrail/sections/section_contacts.h>
#include <wheelrail/sections/sections_command.h>
#include <wheelrail/verdict/rules.h>
#include <wheelrail/wheel/halfspace_parts.h>
#include <wheelrail/wheel/irregular_places.h>
#include <wheelrail/wheel/wheel_load.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <vector>

namespace wheelrail
{
  namespace
  {
    constexpr double per_degree = M_PI / 180;

    /// A wheel on rails by slices.
    struct SceneSections
    {
      std::vector<SectionsSurface> rails;
      WheelProfile                 wheel;
      PosedWheel                   posed;
      std::vector<double>          places; ///< along the path [m]
    };

    Placement
    placement_of(const Scene &scene)
    {
      return {{}, -std::atan(scene.track.inclination)};
    }

    SceneSections
    scene_sections(const Scene &scene, const std::string &option, std::ostream &out)
    {
      Scene smooth        = scene;
      smooth.rail_profile = "";
      if (smooth.irregular())
        throw InputError("Profiles/Rail = " + scene.rail_profile +
                         ": rails by slices have no irregularities: leave the subsections Irregularity out");
      if (scene.roll == RollMode::from_contact)
        throw InputError(
          "Wheelset/Roll = from contact: the rail of the other wheel is not known beside rails by "
          "slices; give an angle or none");
      const Placement              placement = placement_of(scene);
      std::vector<std::string>     jumps;
      std::vector<SectionsSurface> rails{
        read_rail_slices(scene, "Profiles/Rail", scene.rail_profile, placement, jumps)};
      if (scene.second_rail != "none")
        rails.push_back(read_rail_slices(scene, "Profiles/Second rail", scene.second_rail, placement, jumps));
      for (const std::string &jump : jumps)
        out << "warning: " << jump << "\n";
      SceneProfiles profiles = read_wheel_profile(scene);
      print_notes(profiles.notes, out);
      const PosedWheel posed(profiles.wheel, scene.track, wheelset_pose(scene));
      SceneSections    sections{
        std::move(rails), std::move(profiles.wheel), posed, parse_irregular_places(option, false).values};
      double first = HUGE_VAL, last = -HUGE_VAL; // of all rails: the wheel may stand over a gap
      for (const SectionsSurface &rail : sections.rails)
        {
          first = std::min(first, rail.begin());
          last  = std::max(last, rail.end());
        }
      for (const double place : sections.places)
        {
          const double at = scene.rail_place + place;
          if (at < first || at > last)
            throw InputError("--places \"" + option + "\": the wheel at " + in_mm(at) +
                             " along the rail does not stand on the slices, which reach from " +
                             in_mm(first) + " to " + in_mm(last) + "; Profiles/Rail place is " +
                             in_mm(scene.rail_place));
          for (const SectionsSurface &rail : sections.rails)
            rail.refuse_jump(at);
        }
      return sections;
    }

    SectionRolling
    rolling_of(const Scene &scene)
    {
      SectionRolling rolling;
      rolling.problem        = halfspace_problem(scene);
      rolling.section_normal = scene.halfspace_section_normal;
      rolling.dx = rolling.dy = scene.halfspace_element_size;
      rolling.turning =
        scene.velocity / scene.track.nominal_radius * (1 + (scene.drive == Drive::rate ? scene.creepage : 0));
      return rolling;
    }

    /// What is solved at a place.
    struct PlaceResult
    {
      SectionContacts contacts;
      std::string     fault;
      double          noise = 0; ///< twice the spread of the highest peak by noise of the slices, over it
    };

    double
    highest_peak(const SectionContacts &contacts)
    {
      double highest = 0;
      for (const SectionPatch &patch : contacts.patches)
        highest = std::max(highest, patch.solution.peak_pressure);
      return highest;
    }

    /// Solves the places again with other rails that noise of their slices leaves possible.
    void
    find_noise(const Scene              &scene,
               const SceneSections      &sections,
               const SectionRolling     &rolling,
               const double              load,
               std::vector<PlaceResult> &results)
    {
      constexpr unsigned int draws = 4;
      if (std::all_of(sections.rails.begin(), sections.rails.end(), [](const SectionsSurface &rail) {
            return !(rail.noise() > 0);
          }))
        return;
      std::vector<double> squares(results.size(), 0);
      for (unsigned int draw = 1; draw <= draws; ++draw)
        {
          std::vector<SectionsSurface> rails;
          for (const SectionsSurface &rail : sections.rails)
            rails.push_back(drawn_rail_slices(scene, rail, placement_of(scene), draws * rails.size() + draw));
          parallel_for(results.size(), [&](const std::size_t k) {
            const double peak = highest_peak(contacts_under_load(
              rails, sections.posed, rolling, scene.rail_place + sections.places[k], load));
            squares[k] += std::pow(peak / highest_peak(results[k].contacts) - 1, 2);
          });
        }
      for (std::size_t k = 0; k < results.size(); ++k)
        results[k].noise = 2 * std::sqrt(squares[k] / draws);
    }

    int
    patches_of_few_elements(const PlaceResult &result)
    {
      return static_cast<int>(std::count_if(
        result.contacts.patches.begin(), result.contacts.patches.end(), [](const SectionPatch &patch) {
          return elements_across(patch.solution) < least_elements_across;
        }));
    }

    /// Why a place is not trusted; empty: it is.
    std::string
    doubts_of(const PlaceResult &result, const Scene &scene)
    {
      if (!result.fault.empty())
        return result.fault;
      Verdict  verdict;
      Measures measures;
      measures.peak_pressure = highest_peak(result.contacts);
      judge_place(measures, verdict);
      if (!(result.noise <= scene.wanted_accuracy))
        add(verdict,
            Grade::not_trusted,
            text("slices that are off as a whole leave the peak pressure uncertain by %.1f %%; take more, or "
                 "smoother ones.",
                 100 * result.noise));
      if (patches_of_few_elements(result) > 0)
        add(verdict,
            Grade::not_trusted,
            text("fewer than %d elements lie across a patch.", least_elements_across));
      return verdict.doubts();
    }

    std::string
    fault_of(const SectionContacts &contacts)
    {
      if (!contacts.found)
        return "how the patches share the load was not found";
      for (const TouchingPlace &place : contacts.touching)
        if (place.at_end && place.height > contacts.height)
          return "the wheel touches the end or the edge of a rail, where half-spaces know no pressure";
      for (const SectionPatch &patch : contacts.patches)
        if (patch.solution.touches_grid_edge)
          return "a contact reaches the edge of its grid";
      return "";
    }

    void
    print_results(const Scene                    &scene,
                  const SceneSections            &sections,
                  const std::vector<PlaceResult> &results,
                  std::ostream                   &out)
    {
      out << "Wheel on rails by slices; its drop counts from where the running circle is at the height 0 of "
             "the "
             "slices.\nOf each patch: rail, place on its section (positive to the field side), ahead of the "
             "axle\n\n"
             "     place       drop  rail         x     ahead     angle      force       peak      area  "
             "creepage\n"
             "        mm         mm              mm        mm       deg          N        MPa       mm2      "
             "   %\n";
      int coarse = 0;
      for (std::size_t k = 0; k < results.size(); ++k)
        {
          const SectionContacts &c     = results[k].contacts;
          std::string            place = text("%10.3f %10.5f", 1e3 * sections.places[k], -1e3 * c.height);
          for (const SectionPatch &p : c.patches)
            {
              out << place
                  << text(" %5d %9.3f %9.3f %9.3f %10.1f %10.1f %9.3f %9.4f\n",
                          static_cast<int>(p.rail) + 1,
                          -1e3 * p.reference[0],
                          1e3 * (sections.posed.ahead(p.reference)),
                          p.angle / per_degree,
                          p.normal_force(),
                          1e-6 * p.solution.peak_pressure,
                          1e6 * p.solution.contact_elements * p.problem.grid.element_area(),
                          100 * p.solution.xi);
              place = std::string(21, ' ');
            }
          coarse += patches_of_few_elements(results[k]);
          if (const std::string doubts = doubts_of(results[k], scene); !doubts.empty())
            out << text("%10.3f not trusted: ", 1e3 * sections.places[k]) << doubts << "\n";
        }
      if (coarse > 0)
        out << "warning: fewer than " << least_elements_across << " elements lie across " << coarse
            << (coarse == 1 ? " patch" : " patches")
            << ", whose peak pressure may be off by 5 % and more: take a smaller Half-space/Element size\n";
    }

    FigureTable
    table_of(const Scene &scene, const SceneSections &sections, const std::vector<PlaceResult> &results)
    {
      FigureTable table;
      table.add_columns(
        "place_m m, wheel_drop_m m, rail 1, lateral_m m, height_m m, ahead_m m, angle_rad rad, "
        "normal_force_N N, force_along_N N, force_lateral_N N, force_vertical_N N, max_pressure_Pa Pa, "
        "area_m2 m2, approach_m m, rolling_radius_m m, creepage 1, lateral_creepage 1, trusted 1");
      for (std::size_t k = 0; k < results.size(); ++k)
        {
          const double trusted = doubts_of(results[k], scene).empty() ? 1 : 0;
          for (const SectionPatch &p : results[k].contacts.patches)
            {
              const Vector3 force = p.force();
              table.add_row({sections.places[k],
                             -results[k].contacts.height,
                             static_cast<double>(p.rail + 1),
                             -p.reference[0],
                             p.reference[1],
                             sections.posed.ahead(p.reference),
                             p.angle,
                             p.normal_force(),
                             force[2],
                             force[0],
                             -force[1],
                             p.solution.peak_pressure,
                             p.solution.contact_elements * p.problem.grid.element_area(),
                             p.approach,
                             p.radius,
                             p.solution.xi,
                             p.solution.eta,
                             trusted});
            }
        }
      return table;
    }

    /// The sections of all rails over the path, for pictures.
    FigureTable
    table_of_sections(const ProfileSettings &scene, const SceneSections &sections)
    {
      constexpr int wanted = 40;
      FigureTable   table;
      for (const char *key : {"rail", "place_m", "lateral_m", "height_m"})
        table.add(key, std::string(key) == "rail" ? "1" : "m", {});
      const auto [low, high] = std::minmax_element(sections.places.begin(), sections.places.end());
      const double margin    = 20e-3;
      for (std::size_t r = 0; r < sections.rails.size(); ++r)
        for (int i = 0; i <= wanted; ++i)
          {
            const double        place  = *low - margin + (*high - *low + 2 * margin) * i / wanted;
            const SectionColumn column = sections.rails[r].column(scene.rail_place + place);
            for (const Point2 &p : column.points())
              table.add_row({static_cast<double>(r + 1), place, -p.x, p.y});
          }
      return table;
    }
  } // namespace


  int
  print_touching_places(const Scene &scene, const std::string &places, std::ostream &out)
  {
    const SceneSections sections = scene_sections(scene, places, out);
    out << "Rigid wheel on rails by slices: its drop at the first touch, counted from where the running "
           "circle is at "
           "the height 0\nof the slices, and all places that 1 mm more would close; x positive to the field "
           "side, "
           "slope along the track\n\n"
           "     place        drop  rail    rail x   wheel x     ahead       gap     angle     slope     "
           "radius\n"
           "        mm          mm              mm        mm        mm        mm       deg      mrad         "
           "mm\n";
    for (const double place : sections.places)
      {
        std::string begin;
        for (const TouchingPlace &p :
             touching_places(sections.rails, sections.posed, scene.rail_place + place))
          {
            begin =
              begin.empty() ? text("%10.3f %11.5f", 1e3 * place, -1e3 * p.height) : std::string(22, ' ');
            out << begin
                << text(" %5d %9.3f %9.3f %9.3f %9.5f %9.3f %9.2f %10.4f%s\n",
                        static_cast<int>(p.rail) + 1,
                        -1e3 * p.place[0],
                        1e3 * p.wheel.x,
                        1e3 * p.ahead,
                        1e3 * p.gap,
                        p.angle / per_degree,
                        1e3 * p.slope,
                        1e3 * p.wheel.radius,
                        p.at_end ? "  at an edge" : "");
          }
      }
    return 0;
  }


  int
  run_sections_command(const Scene &scene, const std::string &places, const bool draws, std::ostream &out)
  {
    const SceneSections          sections = scene_sections(scene, places, out);
    const ResultFolder           held(scene.folder, "-halfspace");
    const std::filesystem::path &folder = held.path();
    const double                 load   = static_wheel_load(scene, sections.wheel);
    print_head(scene, load, out);
    if (scene.drive == Drive::torque)
      out << "note: a wheel on rails by slices turns at velocity over nominal radius; Wheelset/Traction "
             "coefficient has no effect\n";
    TaskCount                count("places", sections.places.size(), 0, out);
    const SectionRolling     rolling = rolling_of(scene);
    std::vector<PlaceResult> results(sections.places.size());
    parallel_for(results.size(), [&](const std::size_t k) {
      results[k].contacts = contacts_under_load(
        sections.rails, sections.posed, rolling, scene.rail_place + sections.places[k], load);
      results[k].fault = fault_of(results[k].contacts);
      count.one_more();
    });
    find_noise(scene, sections, rolling, load, results);
    print_results(scene, sections, results, out);
    replace_file((folder / "parameters.prm").string(), print_parameters(scene));
    table_of(scene, sections, results).write_csv((folder / "places.csv").string());
    table_of_sections(scene, sections).write_csv((folder / "sections.csv").string());
    out << "Table in " << (folder / "places.csv").string() << std::endl;
    if (draws)
      draw_results("section_places.py", folder.string());
    return std::all_of(results.begin(), results.end(), [](const PlaceResult &r) { return r.fault.empty(); })
             ? 0
             : 2;
  }
} // namespace wheelrail
