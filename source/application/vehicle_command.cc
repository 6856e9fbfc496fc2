#include <wheelrail/application/report_script.h>
#include <wheelrail/application/vehicle_command.h>
#include <wheelrail/input/listing.h>
#include <wheelrail/output/figure_table.h>
#include <wheelrail/output/figures.h>
#include <wheelrail/output/folder.h>
#include <wheelrail/output/replace_file.h>
#include <wheelrail/reference/several_patches.h>
#include <wheelrail/reference/vehicle.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <mutex>
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
      static const std::vector<std::string> keys = {"longitudinal_force_N",
                                                    "lateral_force_N",
                                                    "vertical_force_N",
                                                    "normal_force_N",
                                                    "tangential_lateral_force_N",
                                                    "wheelset_longitudinal_force_N",
                                                    "wheelset_lateral_force_N",
                                                    "drive_torque_Nm",
                                                    "yaw_moment_Nm",
                                                    "creepage",
                                                    "reference_creepage",
                                                    "reference_lateral_creepage",
                                                    "reference_spin_per_m",
                                                    "reference_spin_moment_Nm",
                                                    "reference_lateral_m",
                                                    "reference_along_m",
                                                    "reference_ahead_of_axle_m",
                                                    "reference_angle_rad",
                                                    "wheelset_roll_rad",
                                                    "approach_m",
                                                    "max_pressure_Pa",
                                                    "max_shear_traction_Pa",
                                                    "contact_area_m2",
                                                    "patch_lateral_m",
                                                    "patch_longitudinal_m",
                                                    "stick_fraction",
                                                    "t_gamma_N",
                                                    "frictional_power_W",
                                                    "largest_von_mises_Pa",
                                                    "patches"};
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
        table.add_figures({"normal_force_N",
                           "longitudinal_force_N",
                           "tangential_lateral_force_N",
                           "reference_angle_rad",
                           "reference_creepage",
                           "reference_lateral_creepage",
                           "reference_spin_per_m",
                           "max_pressure_Pa",
                           "contact_area_m2",
                           "t_gamma_N"},
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

    FigureTable
    table_of(const MotionFile &motion, const std::vector<VehicleWheel> &wheels)
    {
      FigureTable         table;
      std::vector<double> numbers;
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
          std::vector<double> good;
          for (const std::string &fault : wheel.faults)
            good.push_back(fault.empty() ? 1 : 0);
          table.add(side + "trusted", "1", good);
        }
      return table;
    }

    void
    print_worst(const FigureTable &table, const std::vector<VehicleWheel> &wheels, std::ostream &out)
    {
      const auto &abscissa = table.columns[1];
      for (const VehicleWheel &wheel : wheels)
        for (const char *const name : {"max_pressure", "t_gamma", "largest_von_mises"})
          {
            const Figure     &figure = figure_named(name);
            const auto *const column = table.find((wheel.left ? "left_" : "right_") + figure.key());
            if (!column)
              continue;
            std::size_t worst = 0;
            for (std::size_t row = 0; row < column->size(); ++row)
              if (!(std::isfinite((*column)[worst]) && (*column)[worst] >= (*column)[row]) &&
                  std::isfinite((*column)[row]))
                worst = row;
            char text[200];
            std::snprintf(text,
                          sizeof(text),
                          "  %s wheel, worst row by %-24s %10s %-4s row %zu (%s = %.6g)\n",
                          wheel.left ? "left" : "right",
                          figure.label,
                          figure.shown((*column)[worst]).c_str(),
                          figure.unit,
                          worst + 1,
                          table.keys[1].c_str(),
                          abscissa[worst]);
            out << text;
          }
    }

    /// Tells the faults, the same one once with the number of its rows; their number.
    std::size_t
    print_faults(const std::vector<VehicleWheel> &wheels, std::ostream &out)
    {
      std::size_t count = 0, told = 0;
      for (const VehicleWheel &wheel : wheels)
        for (std::size_t row = 0; row < wheel.faults.size(); ++row)
          if (!wheel.faults[row].empty() && ++count && ++told <= 5)
            out << "row " << row + 1 << ", " << (wheel.left ? "left" : "right")
                << " wheel: " << wheel.faults[row] << '\n';
      if (count > 5)
        out << "and " << count - 5 << " more; the column trusted of vehicle.csv has 0 there\n";
      return count;
    }
  } // namespace


  int
  run_vehicle_command(const Scene         &scene,
                      const SceneProfiles &profiles,
                      const MotionFile    &motion,
                      const bool           both_wheels,
                      const bool           draws,
                      std::ostream        &out)
  {
    const std::filesystem::path folder = folder_beside(scene.folder, "-vehicle");
    replace_file((folder / "parameters.prm").string(), print_parameters(scene));

    const auto                begin = std::chrono::steady_clock::now();
    std::vector<VehicleWheel> wheels;
    std::mutex                lock;
    for (const bool left : both_wheels ? std::vector<bool>{false, true} : std::vector<bool>{scene.left_wheel})
      wheels.push_back(solve_vehicle(scene, profiles, motion, left, [&](const std::size_t done) {
        const std::lock_guard<std::mutex> guard(lock);
        if (done % 200 == 0)
          out << (left ? "left" : "right") << " wheel: " << done << " of " << motion.rows() << " rows"
              << std::endl;
      }));
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();

    const FigureTable table = table_of(motion, wheels);
    table.write_csv((folder / "vehicle.csv").string());
    table.write_hdf5((folder / "vehicle.h5").string());
    char text[160];
    std::snprintf(text,
                  sizeof(text),
                  "%zu rows of %zu wheel(s) in %.1f s, %.3f s a row\n",
                  motion.rows(),
                  wheels.size(),
                  seconds,
                  seconds / (motion.rows() * wheels.size()));
    out << text;
    print_worst(table, wheels, out);
    const std::size_t faults = print_faults(wheels, out);
    out << "Results in " << folder.string() << std::endl;
    if (draws)
      draw_results("vehicle.py", folder.string());
    return faults == 0 ? 0 : 2;
  }
} // namespace wheelrail
