#include <wheelrail/base/errors.h>
#include <wheelrail/base/format_text.h>
#include <wheelrail/base/parallel.h>
#include <wheelrail/bodies/answering_bodies.h>
#include <wheelrail/bodies/shift_effect.h>
#include <wheelrail/commands/halfspace_results.h>
#include <wheelrail/commands/report_script.h>
#include <wheelrail/geometry/track.h>
#include <wheelrail/input/cross_checks.h>
#include <wheelrail/input/listing.h>
#include <wheelrail/model/section_file.h>
#include <wheelrail/output/figures.h>
#include <wheelrail/output/folder.h>
#include <wheelrail/output/replace_file.h>
#include <wheelrail/vehicle/wheelset_command.h>
#include <wheelrail/vehicle/wheelset_figures.h>
#include <wheelrail/wheel/noise_effect.h>
#include <wheelrail/wheel/wheel_load.h>

#include <cmath>
#include <cstddef>
#include <filesystem>
#include <iomanip>
#include <optional>
#include <sstream>

namespace wheelrail
{
  namespace
  {
    /// The rows of one wheel, which was computed as its mirror image when it is the left one.
    class WheelRows
    {
    public:
      WheelRows(const WheelOnAxle &wheel, const bool left, std::ostream &file)
        : geometry_(wheel.geometry)
        , side_(left ? "left" : "right")
        , to_right_(left ? -1 : 1)
        , middle_(running_circle_distance(wheel.scene.track))
        , file_(file)
      {
      }

      void
      add_profiles() const
      {
        add_curve("rail", geometry_.rail.head, geometry_.contact.rail);
        add_curve("wheel", geometry_.wheel.tread, geometry_.contact.wheel);
      }

      void
      add_patch(const WheelRailSolution &patch) const
      {
        add_place("contact", patch.reference->place);
        add("force", -to_right_ * 1e-3 * patch.lateral, 1e-3 * patch.vertical);
        add("peak pressure", 1e-6 * patch.solution.peak_pressure, 1e6 * patch.measures.area);
        // from edge to edge, along the mean plane
        const Point2 half = 0.5 * patch.measures.width * Point2{std::cos(patch.angle), std::sin(patch.angle)};
        add_place("edge", patch.reference->place - half);
        add_place("edge", patch.reference->place + half);
      }

    private:
      void
      add(const std::string &what, const double x, const double y) const
      {
        file_ << side_ << ',' << what << ',' << x << ',' << y << '\n';
      }

      /// A place of the track plane in which the wheel was computed.
      void
      add_place(const std::string &what, const Point2 &place) const
      {
        add(what, to_right_ * 1e3 * (middle_ - place.x), 1e3 * place.y);
      }

      void
      add_curve(const std::string &what, const Curve &curve, const Placement &placement) const
      {
        for (const Segment &segment : curve.segments())
          {
            const int n = samples_on(segment, 16);
            for (int i = 0; i <= n; ++i)
              add_place(what, placement.to_track(position_on(segment, static_cast<double>(i) / n)));
          }
      }

      const SceneGeometry &geometry_;
      std::string          side_;
      double               to_right_, middle_;
      std::ostream        &file_;
    };

    /// Writes what the picture of a wheelset on its rails shows (source/report/wheelset.py) as rows "side,
    /// what, x, y": the outlines of both heads and treads, the patches from edge to edge on the rail, and,
    /// each as a place and an arrow behind it, the forces of the patches on the wheels. Places in mm, seen
    /// along the track: x to the right from the middle of the track, y upwards from the running circles;
    /// forces in kN. Throws RunError when it cannot be written.
    void
    write_wheelset_lines(const WheelsetSolution &wheelset, const std::string &path)
    {
      std::ostringstream file;
      file << std::setprecision(9) << "side,what,x,y\n";
      for (const bool left : {false, true})
        {
          const WheelRows rows(left ? wheelset.left : wheelset.right, left, file);
          rows.add_profiles();
          if (const auto &solution = left ? wheelset.axle.left : wheelset.axle.right)
            {
              rows.add_patch(*solution);
              for (const WheelRailSolution &other : solution->others)
                rows.add_patch(other);
            }
        }
      replace_file(path, file.str());
    }

    /// A wheelset by the bodies of its scene, and why others than true ones answer.
    struct Solved
    {
      WheelsetSolution wheelset;
      std::string      note;
    };

    /// With the load that the wheel of the profiles has.
    Solved
    solve(const Scene &scene, const WheelsetProfiles &profiles)
    {
      Scene base      = scene;
      base.wheel_load = static_wheel_load(scene, profiles.right.wheel);
      Solved solved;
      solved.note = solve_with_bodies(base, [&]() {
        solved.wheelset = solve_wheelset(
          wheel_of_wheelset(base, false), wheel_of_wheelset(base, true), profiles, std::nullopt, 2);
      });
      return solved;
    }

    /// One row of a table with a column for each wheel.
    void
    print_row(const std::string &label,
              const std::string &unit,
              const std::string (&values)[2],
              std::ostream &out)
    {
      out << "  " << std::left << std::setw(38) << label << std::right << std::setw(12) << values[0]
          << std::setw(12) << values[1] << "  " << unit << '\n';
    }

    /// Below the peak pressure of true bodies.
    void
    print_halfspaces(const std::optional<HalfspaceResults> (&wheels)[2], std::ostream &out)
    {
      std::string values[2];
      for (int k = 0; k < 2; ++k)
        if (wheels[k])
          if (const double peak = get_figure(wheels[k]->figures, "halfspace_max_pressure_Pa");
              std::isfinite(peak))
            values[k] = figure_named("max_pressure").shown(peak);
      if (!(values[0] + values[1]).empty())
        print_row("  as half-spaces", "MPa", values, out);
    }

    void
    print_wheels(const std::optional<HalfspaceResults> (&wheels)[2], std::ostream &out)
    {
      print_row("", "", {"right", "left"}, out);
      for (const std::string &name :
           split_list("vertical_force, lateral_force, lateral_over_vertical, longitudinal_force, "
                      "reference_creepage, reference_lateral_creepage, reference_spin, t_gamma, "
                      "max_pressure, contact_area, patches, reference_lateral, patch_centre_from_axis, "
                      "patch_centre_from_gauge_face, reference_radius, subsurface_von_mises"))
        {
          const Figure &figure = figure_named(name);
          std::string   values[2];
          bool          any = false;
          for (int k = 0; k < 2; ++k)
            {
              const double value = wheels[k] ? get_figure(wheels[k]->figures, figure.key()) : std::nan("");
              values[k]          = wheels[k] ? figure.shown(value) : "lifted";
              any                = any || std::isfinite(value);
            }
          if (any)
            print_row(figure.label, figure.unit, values, out);
          if (figure.key() == "max_pressure_Pa")
            print_halfspaces(wheels, out);
        }
      out << "  Lateral forces are positive to the track centre, and so are places from the running circle "
             "and the axis.\n";
    }

    void
    print_axle(const Summary &axle, std::ostream &out)
    {
      out << "Axle:\n";
      for (const Figure &figure : all_figures())
        if (const double value = get_figure(axle, figure.key());
            std::string(figure.name).rfind("axle_", 0) == 0 && std::isfinite(value))
          out << "  " << std::left << std::setw(46) << figure.label << std::right << std::setw(12)
              << figure.shown(value) << "  " << figure.unit
              << (*figure.remark ? std::string(", ") + figure.remark : "") << '\n';
    }
  } // namespace


  int
  run_wheelset_command(const Scene &scene, const bool draws, std::ostream &out)
  {
    const WheelsetProfiles       profiles = profiles_with_notes(scene, out);
    const ResultFolder           held(scene.folder, "-halfspace");
    const std::filesystem::path &folder = held.path();
    print_head(scene, static_wheel_load(scene, profiles.right.wheel), out);
    Solved                          solved   = solve(scene, profiles);
    WheelsetSolution               &wheelset = solved.wheelset;
    std::optional<HalfspaceResults> wheels[2];
    parallel_for(2, [&](const std::size_t left) {
      if (auto &solution = left ? wheelset.axle.left : wheelset.axle.right)
        {
          const WheelOnAxle &wheel = left ? wheelset.left : wheelset.right;
          hold_against_bodies(wheel.scene, wheel.geometry, *solution);
          find_noise_effect(wheel.scene, wheel.geometry, *solution);
          HalfspaceResults &results = wheels[left].emplace(halfspace_results(wheel.scene, *solution));
          set_wheel_figures(wheelset, left, results.figures);
          if (wheel.scene.halfspace_bodies == ContactBodies::real)
            add_halfspaces(wheel.scene,
                           wheel.geometry,
                           load_of_wheel(wheel, wheelset.axle.rate, std::nullopt),
                           results.figures);
        }
    });
    Summary axle = wheelset_summary(
      scene, wheelset, wheels[0] ? &wheels[0]->figures : nullptr, wheels[1] ? &wheels[1]->figures : nullptr);
    if (axle.note.empty())
      axle.note = solved.note;
    remove_earlier_results(folder);
    Scene answered            = scene;
    answered.halfspace_bodies = wheelset.right.scene.halfspace_bodies;
    replace_file((folder / "parameters.prm").string(), print_parameters(answered));
    for (const bool left : {false, true})
      if (wheels[left])
        {
          const std::filesystem::path own = folder / (left ? "left" : "right");
          std::filesystem::create_directories(own);
          Scene single  = single_wheel(wheelset, left);
          single.folder = (std::filesystem::path(scene.folder) / (left ? "left" : "right")).string();
          write_halfspace_folder(
            single, left ? *wheelset.axle.left : *wheelset.axle.right, *wheels[left], own.string());
          const WheelOnAxle &wheel = left ? wheelset.left : wheelset.right;
          write_sections(wheel.geometry, wheel.scene.track, (own / "sections.json").string());
          if (draws)
            draw_results("halfspace.py", own.string());
        }
    write_summary(axle, (folder / "summary.json").string());
    write_wheelset_lines(wheelset, (folder / "wheelset.csv").string());
    if (draws)
      draw_results("wheelset.py", folder.string());
    print_wheels(wheels, out);
    print_axle(axle, out);
    if (!axle.note.empty())
      out << axle.note << '\n';
    out << verdict_line(axle) << '\n';
    out << "Results in " << folder.string() << std::endl;
    return axle.finished ? 0 : 2;
  }


  std::string
  take_wheel(const po::variables_map &options, SceneInput &input)
  {
    if (!options.count("wheelset"))
      return "";
    input.scene.both_wheels = true;
    require_none(contact_checks(input.scene).errors, input);
    const Scene scene          = input.scene;
    const auto [wheelset, why] = solve(scene, read_wheelset_profiles(scene));
    const auto       &own      = scene.left_wheel ? wheelset.axle.left : wheelset.axle.right;
    const std::string side     = scene.left_wheel ? "left" : "right";
    if (!own)
      throw InputError("--wheelset: the " + side +
                       "-hand wheel is lifted in this curve; run the other side, or change radius, cant or "
                       "velocity");
    if (!own->solution.not_reached.empty())
      throw InputError("--wheelset: " + own->solution.not_reached +
                       "Look at the wheelset with the command halfspace first");
    input.scene       = single_wheel(wheelset, scene.left_wheel);
    const Scene &at   = input.scene;
    std::string  note = "from the wheelset: load " + text("%.2f kN", 1e-3 * at.wheel_load) +
                       ", lateral shift " + text("%.3f mm", 1e3 * at.lateral_shift) + ", yaw " +
                       text("%.3f mrad", 1e3 * at.yaw);
    if (at.drive == Drive::rate)
      note += ", creepage " + text("%.4f %%", 100 * at.creepage);
    note += "; the run rolls straight on";
    return why.empty() ? note : note + ". " + why;
  }
} // namespace wheelrail
