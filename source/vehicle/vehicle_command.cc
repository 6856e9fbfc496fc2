#include <wheelrail/base/errors.h>
#include <wheelrail/base/format_text.h>
#include <wheelrail/base/hints.h>
#include <wheelrail/base/interrupt.h>
#include <wheelrail/base/progress.h>
#include <wheelrail/commands/report_script.h>
#include <wheelrail/commands/row_verdicts.h>
#include <wheelrail/commands/scene_row.h>
#include <wheelrail/damage/wear_profile.h>
#include <wheelrail/input/cross_checks.h>
#include <wheelrail/input/entries.h>
#include <wheelrail/input/listing.h>
#include <wheelrail/input/motion_file.h>
#include <wheelrail/input/scene_files.h>
#include <wheelrail/input/without_effect.h>
#include <wheelrail/model/section_file.h>
#include <wheelrail/output/figure_table.h>
#include <wheelrail/output/figures.h>
#include <wheelrail/output/folder.h>
#include <wheelrail/output/replace_file.h>
#include <wheelrail/vehicle/vehicle.h>
#include <wheelrail/vehicle/vehicle_command.h>
#include <wheelrail/vehicle/vehicle_rows.h>
#include <wheelrail/vehicle/wheelset_figures.h>
#include <wheelrail/verdict/verdict.h>
#include <wheelrail/wheel/given_distance.h>
#include <wheelrail/wheel/several_patches.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace wheelrail
{
  namespace
  {
    const std::vector<std::string> &
    figure_keys()
    {
      static const std::vector<std::string> keys = [] {
        std::vector<std::string> list = split_list(
          "longitudinal_force_N, lateral_force_N, vertical_force_N, normal_force_N, "
          "tangential_lateral_force_N, wheelset_longitudinal_force_N, wheelset_lateral_force_N, "
          "drive_torque_Nm, yaw_moment_Nm, creepage, creepage_low, creepage_high, reference_creepage, "
          "reference_lateral_creepage, reference_spin_per_m, reference_spin_moment_Nm, reference_lateral_m, "
          "reference_along_m, reference_ahead_of_axle_m, reference_angle_rad, lateral_over_vertical, "
          "wheelset_roll_rad, approach_m, max_pressure_Pa, max_pressure_low_Pa, max_pressure_high_Pa, "
          "max_shear_traction_Pa, contact_area_m2, contact_area_low_m2, contact_area_high_m2, "
          "patch_lateral_m, patch_longitudinal_m, stick_fraction, t_gamma_N, lateral_force_low_N, "
          "lateral_force_high_N, longitudinal_force_low_N, longitudinal_force_high_N, t_gamma_low_N, "
          "t_gamma_high_N, frictional_power_W");
        list.insert(list.end(), worst_wear_keys().begin(), worst_wear_keys().end());
        for (const std::string &key : split_list(
               "archard_section_m2, largest_von_mises_Pa, halfspace_max_pressure_Pa, bodies_max_pressure_Pa, "
               "patches, patch_centre_from_axis_m, patch_centre_from_gauge_face_m, patch_centre_below_top_m"))
          list.push_back(key);
        return list;
      }();
      return keys;
    }

    /// Figures of each patch, where a row has several.
    void
    add_patches(FigureTable &table, const std::vector<Summary> &rows)
    {
      double most = 0;
      for (const Summary &row : rows)
        if (const double n = get_figure(row, "patches"); n > most)
          most = n;
      for (int k = 1; k <= most; ++k)
        table.add_figures(
          split_list("normal_force_N, longitudinal_force_N, tangential_lateral_force_N, reference_angle_rad, "
                     "reference_lateral_m, reference_creepage, reference_lateral_creepage, "
                     "reference_spin_per_m, max_pressure_Pa, contact_area_m2, t_gamma_N, "
                     "patch_centre_from_axis_m, patch_centre_from_gauge_face_m, patch_centre_below_top_m"),
          rows,
          patch_prefix(k));
    }

    /// A column of the motion, under its name and its SI unit.
    void
    add_motion(FigureTable &table, const MotionFile &motion, const std::size_t column)
    {
      const MotionQuantity quantity = motion.quantities[column];
      const std::string    unit     = motion_unit(quantity);
      std::string          key      = "given_" + motion_name(quantity);
      if (unit != "1")
        key += "_" + unit;
      for (const auto &[from, to] : {std::pair(" ", "_"), std::pair("/", "_per_")})
        for (std::size_t at; (at = key.find(from)) != std::string::npos;)
          key.replace(at, 1, to);
      table.add(key, unit, motion.columns[column]);
    }

    /// That of its figures; a row without figures is not trusted.
    Grade
    grade_of_row(const VehicleWheel &wheel, const std::size_t row)
    {
      return wheel.faults[row].empty() ? grade_of(wheel.rows[row]) : Grade::not_trusted;
    }

    /// A column of each quantity that the rows give ("given_..."), then the figures of each wheel
    /// ("right_...", "left_..."), of each of its patches, its verdict, and the figures of the axle; a line a
    /// row.
    FigureTable
    vehicle_table(const MotionFile &motion, const VehicleResult &vehicle)
    {
      const std::vector<VehicleWheel> &wheels = vehicle.wheels;
      FigureTable                      table;
      std::vector<double>              numbers;
      for (std::size_t row = 0; row < motion.rows(); ++row)
        numbers.push_back(row + 1.);
      table.add("row", "1", numbers);
      for (std::size_t k = 0; k < motion.quantities.size(); ++k)
        add_motion(table, motion, k);
      for (const VehicleWheel &wheel : wheels)
        {
          const std::string side = wheel.left ? "left_" : "right_";
          FigureTable       own;
          own.add_figures(figure_keys(), wheel.rows);
          add_patches(own, wheel.rows);
          for (std::size_t k = 0; k < own.keys.size(); ++k)
            table.add(side + own.keys[k], own.units[k], own.columns[k]);
          std::vector<double> good, grades;
          for (std::size_t row = 0; row < wheel.rows.size(); ++row)
            {
              const Grade grade = grade_of_row(wheel, row);
              grades.push_back(static_cast<double>(grade));
              good.push_back(grade == Grade::trusted ? 1 : 0);
            }
          table.add(side + "verdict", "1", grades);
          table.add(side + "trusted", "1", good);
        }
      table.add_figures(axle_keys(), vehicle.axle);
      return table;
    }

    /// Rail and wheel of one side in the middle of the track, on which the page draws the running band.
    void
    write_sections_of(const Scene &scene, const SceneProfiles &profiles, const std::string &path)
    {
      Scene middle         = scene;
      middle.lateral_shift = 0;
      middle.yaw           = 0;
      try
        {
          write_sections(make_geometry(middle, profiles), scene.track, path);
        }
      catch (const InputError &) // profiles that touch in the rows alone: the page goes without them
        {
        }
    }

    void
    print_worst(const FigureTable &table, const std::vector<VehicleWheel> &wheels, std::ostream &out)
    {
      const auto *const along    = table.find("given_distance_m");
      const auto       &abscissa = along ? *along : *table.find("given_time_s");
      for (const VehicleWheel &wheel : wheels)
        for (const char *const name : {"max_pressure", "t_gamma", "largest_von_mises"})
          {
            const Figure     &figure = figure_named(name);
            const auto *const column = table.find((wheel.left ? "left_" : "right_") + figure.key());
            if (!column)
              continue;
            const auto known = [&](const std::size_t row) { // of a row that was solved
              return wheel.faults[row].empty() && std::isfinite((*column)[row]);
            };
            std::size_t worst = 0;
            for (std::size_t row = 1; row < column->size(); ++row)
              if (known(row) && !(known(worst) && (*column)[worst] >= (*column)[row]))
                worst = row;
            if (!known(worst))
              continue;
            out << text("  %s wheel, worst row by %-24s %10s %-4s row %zu, %s %.6g %s\n",
                        wheel.left ? "left" : "right",
                        figure.label,
                        figure.shown((*column)[worst]).c_str(),
                        figure.unit,
                        worst + 1,
                        along ? "distance" : "time",
                        abscissa[worst],
                        along ? "m" : "s");
          }
    }

    /// Half-spaces beside true bodies, and rows that half-spaces answer alone.
    void
    print_halfspaces(const std::vector<VehicleWheel> &wheels, std::ostream &out)
    {
      constexpr double apart = 0.05;
      double           least = 0, most = 0;
      int              all = 0, beyond = 0, alone = 0;
      std::string      why;
      for (const VehicleWheel &wheel : wheels)
        for (const Summary &row : wheel.rows)
          {
            if (!row.note.empty() && ++alone == 1)
              why = row.note;
            const double share = get_figure(row, "halfspace_max_pressure_Pa") / row.max_pressure - 1;
            if (!std::isfinite(share))
              continue;
            ++all;
            beyond += std::abs(share) > apart ? 1 : 0;
            least = std::min(least, share);
            most  = std::max(most, share);
          }
      if (all > 0)
        out << text(
          "Half-spaces beside them: peak pressure %+.1f to %+.1f %%, in %d of %d by more than 5 %%\n",
          100 * least,
          100 * most,
          beyond,
          all);
      if (alone > 0)
        out << "note: " << alone << " by half-spaces alone, the first: " << why << '\n';
    }

    /// Returns the number of rows without figures.
    std::size_t
    print_verdicts(const std::vector<VehicleWheel> &wheels, std::ostream &out)
    {
      std::size_t             faults = 0;
      std::vector<RowVerdict> verdicts;
      for (const VehicleWheel &wheel : wheels)
        for (std::size_t row = 0; row < wheel.rows.size(); ++row)
          {
            const std::string &fault = wheel.faults[row];
            const bool         of_both =
              wheels.size() > 1 && !fault.empty() && wheels[0].faults[row] == wheels[1].faults[row];
            const std::string side = wheel.left ? ", left wheel" : ", right wheel";
            faults += fault.empty() ? 0 : 1;
            verdicts.push_back({"row " + std::to_string(row + 1) + (of_both ? "" : side),
                                grade_of_row(wheel, row),
                                of_both && &wheel != &wheels[0] ? "" // told with the other wheel
                                : fault.empty()                 ? wheel.rows[row].doubts
                                                                : fault});
          }
      print_row_verdicts(verdicts,
                         wheels.size() > 1 ? "contacts of both wheels" : "rows",
                         wheels.size() > 1     ? "right_verdict or left_verdict of vehicle.csv"
                         : wheels.front().left ? "left_verdict of vehicle.csv"
                                               : "right_verdict of vehicle.csv",
                         out);
      return faults;
    }

    std::filesystem::path
    rows_file(const std::filesystem::path &folder)
    {
      return folder / "rows.kept";
    }

    /// All rows; those that an interrupted call has kept in the folder are not solved again.
    VehicleResult
    solve_rows(const Scene                 &scene,
               const WheelsetProfiles      &profiles,
               const MotionFile            &motion,
               const std::filesystem::path &folder,
               const bool                   overwrite,
               std::ostream                &out)
    {
      if (overwrite)
        std::filesystem::remove(rows_file(folder));
      VehicleRows kept(rows_file(folder).string(), scene_digest(scene, WHEELRAIL_VERSION), motion);
      if (kept.count() > 0)
        out << "resuming after " << kept.count() << " of " << motion.rows() << " rows" << std::endl;
      TaskCount count("rows", motion.rows(), kept.restored(), out);
      try
        {
          return solve_vehicle(scene, profiles, motion, &kept, [&]() { count.one_more(); });
        }
      catch (const Interrupted &)
        {
          if (kept.count() == 0)
            throw;
          throw Interrupted(std::to_string(kept.count()) + " of " + std::to_string(motion.rows()) +
                            " rows are kept in " + folder.string() +
                            ": the same command continues with the others");
        }
    }

    /// Cant, which shares the load of an axle, against rows that have the loads of both wheels, or one wheel.
    void
    require_cant_for_loads(const Scene &scene, const MotionFile &motion)
    {
      if (motion.find(MotionQuantity::load_right) && std::isfinite(scene.cant))
        throw InputError(
          entry_text(scene, "Track", "Cant") +
          ": the rows have the loads of both wheels already; write none, or the column load in "
          "their place");
      if (motion.find(MotionQuantity::cant) && !motion.find(MotionQuantity::load_right) && !scene.both_wheels)
        throw InputError(
          "the column cant shares the load of an axle between two wheels: give --both-wheels, or "
          "leave it out");
    }


    int
    run_vehicle_command(const Scene            &scene,
                        const WheelsetProfiles &profiles,
                        const MotionFile       &motion,
                        const bool              draws,
                        const bool              overwrite,
                        std::ostream           &out)
    {
      const auto                       begin = std::chrono::steady_clock::now();
      const ResultFolder               held(scene.folder, "-vehicle");
      const std::filesystem::path     &folder  = held.path();
      const VehicleResult              vehicle = solve_rows(scene, profiles, motion, folder, overwrite, out);
      const std::vector<VehicleWheel> &wheels  = vehicle.wheels;
      const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();

      for (const char *const name : {"vehicle.html", "sections_left.json", "sections_right.json"})
        std::filesystem::remove(folder / name); // of an earlier call, with other wheels
      Scene answered = scene;
      if (scene.halfspace_bodies == ContactBodies::automatic)
        answered.halfspace_bodies = ContactBodies::real;
      replace_file((folder / "parameters.prm").string(), print_parameters(answered));
      const FigureTable table = vehicle_table(motion, vehicle);
      table.write_csv((folder / "vehicle.csv").string());
      table.write_hdf5((folder / "vehicle.h5").string());
      for (const VehicleWheel &wheel : wheels)
        write_sections_of(wheel_of_wheelset(scene, wheel.left),
                          wheel.left ? profiles.left : profiles.right,
                          (folder / (wheel.left ? "sections_left.json" : "sections_right.json")).string());
      out << text("%zu rows of %s in %.1f s, %.3f s a row and wheel\n",
                  motion.rows(),
                  wheels.size() == 1 ? "one wheel" : "both wheels",
                  seconds,
                  seconds / (motion.rows() * wheels.size()));
      const std::size_t faults = print_verdicts(wheels, out);
      print_worst(table, wheels, out);
      print_halfspaces(wheels, out);
      std::filesystem::remove(rows_file(folder)); // all is in the tables
      out << "Results in " << folder.string() << std::endl;
      if (draws)
        draw_results("vehicle.py", folder.string());
      return faults == 0 ? 0 : 2;
    }
  } // namespace


  int
  act_vehicle(const po::variables_map &options, const RunFunction &, std::ostream &out)
  {
    require_file(options, "vehicle");
    if (!options.count("motion"))
      throw InputError("vehicle needs a motion file, such as " + own_call() + " vehicle " +
                       ready_scene("rolling.prm") + " " + ready_scene("s_curve.csv"));
    const MotionFile motion =
      read_vehicle_file(options["motion"].as<std::string>(),
                        options.count("columns") ? options["columns"].as<std::string>() : "");
    print_notes(motion.notes, out);
    SceneInput input = file_input_of(options);
    require_one_scene(input);
    input.scene.motion = "none"; // the rows of the command take its place
    if (options.count("both-wheels"))
      input.scene.both_wheels = true;
    print_notes(entries_without_effect(input, "vehicle"), out);
    print_note(drive_of_rows(input.scene, motion, row_drive_of(options)), out);
    print_note(entries_under_rows(input, motion, options["motion"].as<std::string>()), out);
    if (!input.scene.both_wheels && !has_drive(motion))
      print_note("one wheel, which turns by itself; --both-wheels puts both on one axle", out);
    input.scene = scene_for_rows(input.scene, motion, row_drive_of(options));
    require_cant_for_loads(input.scene, motion);
    require_none(contact_checks(input.scene).errors, input);
    if (distance_is_given(input.scene))
      throw InputError(
        "vehicle takes the distance of wheel and rail: set Half-space/Undeformed distance = profiles");
    settle_bodies(input.scene, "", out);
    return run_vehicle_command(input.scene,
                               profiles_with_notes(input.scene, out),
                               motion,
                               !options.count("no-pictures"),
                               options.count("overwrite") > 0,
                               out);
  }
} // namespace wheelrail
