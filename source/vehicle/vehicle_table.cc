#include <wheelrail/base/format_text.h>
#include <wheelrail/damage/wear_figures.h>
#include <wheelrail/vehicle/vehicle_table.h>
#include <wheelrail/vehicle/wheelset_figures.h>
#include <wheelrail/wheel/several_patches.h>

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
        list.insert(list.end(),
                    {"archard_section_m2",
                     "largest_von_mises_Pa",
                     "halfspace_max_pressure_Pa",
                     "bodies_max_pressure_Pa",
                     "patches",
                     "patch_centre_from_axis_m",
                     "patch_centre_from_gauge_face_m",
                     "patch_centre_below_top_m"});
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
  } // namespace


  Grade
  grade_of_row(const VehicleWheel &wheel, const std::size_t row)
  {
    return wheel.faults[row].empty() ? grade_of(wheel.rows[row]) : Grade::not_trusted;
  }


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
} // namespace wheelrail
