#include <wheelrail/application/report_script.h>
#include <wheelrail/application/vehicle_command.h>
#include <wheelrail/input/listing.h>
#include <wheelrail/output/figure_table.h>
#include <wheelrail/output/hdf5_file.h>
#include <wheelrail/output/replace_file.h>
#include <wheelrail/reference/vehicle.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <mutex>
#include <string>
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
                                                    "largest_von_mises_Pa"};
      return keys;
    }

    /// Key of a column of the motion in the tables, with its SI unit.
    std::string
    motion_key(const MotionQuantity quantity)
    {
      using Q                = MotionQuantity;
      const char *const unit = quantity == Q::time                                       ? "_s"
                               : quantity == Q::distance || quantity == Q::lateral_shift ? "_m"
                               : quantity == Q::roll || quantity == Q::yaw               ? "_rad"
                               : quantity == Q::load                                     ? "_N"
                               : quantity == Q::velocity                                 ? "_m_per_s"
                               : quantity == Q::torque                                   ? "_Nm"
                                                                                         : "";
      std::string       name = motion_name(quantity);
      std::replace(name.begin(), name.end(), ' ', '_');
      return "given_" + name + unit;
    }

    std::string
    unit_of(const std::string &key)
    {
      for (const char *const unit :
           {"_m_per_s", "_per_m", "_rad", "_m2", "_Nm", "_Pa", "_N", "_W", "_m", "_s"})
        {
          const std::string tail = unit;
          if (key.size() > tail.size() && key.compare(key.size() - tail.size(), tail.size(), tail) == 0)
            return tail == "_m_per_s" ? "m/s" : tail == "_per_m" ? "1/m" : tail.substr(1);
        }
      return "1";
    }

    FigureTable
    table_of(const MotionFile &motion, const std::vector<VehicleWheel> &wheels)
    {
      FigureTable         table;
      std::vector<double> numbers;
      for (std::size_t row = 0; row < motion.rows(); ++row)
        numbers.push_back(row + 1.);
      table.add("row", numbers);
      for (std::size_t k = 0; k < motion.quantities.size(); ++k)
        table.add(motion_key(motion.quantities[k]), motion.columns[k]);
      for (const VehicleWheel &wheel : wheels)
        {
          const std::string side = wheel.left ? "left_" : "right_";
          FigureTable       own;
          own.add_figures(figure_keys(), wheel.rows);
          for (std::size_t k = 0; k < own.keys.size(); ++k)
            table.add(side + own.keys[k], own.columns[k]);
          std::vector<double> good;
          for (const std::string &fault : wheel.faults)
            good.push_back(fault.empty() ? 1 : 0);
          table.add(side + "trusted", good);
        }
      return table;
    }

    void
    print_worst(const FigureTable &table, const std::vector<VehicleWheel> &wheels, std::ostream &out)
    {
      struct Rank
      {
        const char *key, *label, *unit;
        double      factor;
      };
      const auto &abscissa = table.columns[1];
      for (const VehicleWheel &wheel : wheels)
        for (const Rank &rank : {Rank{"max_pressure_Pa", "peak pressure", "MPa", 1e-6},
                                 Rank{"t_gamma_N", "T-gamma", "N", 1},
                                 Rank{"largest_von_mises_Pa", "von Mises stress", "MPa", 1e-6}})
          {
            const auto *const column = table.find((wheel.left ? "left_" : "right_") + std::string(rank.key));
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
                          "  %s wheel, largest %-18s %10.1f %-4s in row %zu (%s = %.6g)\n",
                          wheel.left ? "left" : "right",
                          rank.label,
                          rank.factor * (*column)[worst],
                          rank.unit,
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
    std::filesystem::path folder = scene.folder;
    if (!folder.has_filename())
      folder = folder.parent_path();
    folder += "-vehicle";
    std::error_code ignored; // a folder that cannot be made shows when its first file is written
    std::filesystem::create_directories(folder, ignored);
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
    History           history{table.keys, {}, table.columns};
    for (const std::string &key : table.keys)
      history.units.push_back(unit_of(key));
    table.write_csv((folder / "vehicle.csv").string());
    write_history(history, (folder / "vehicle.h5").string());
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
      run_script("vehicle.py", {folder.string()});
    return faults == 0 ? 0 : 2;
  }
} // namespace wheelrail
