#include <wheelrail/base/format_text.h>
#include <wheelrail/base/progress.h>
#include <wheelrail/bodies/body_contact.h>
#include <wheelrail/bodies/shift_effect.h>
#include <wheelrail/commands/report_script.h>
#include <wheelrail/commands/row_verdicts.h>
#include <wheelrail/input/listing.h>
#include <wheelrail/input/motion_file.h>
#include <wheelrail/output/figure_table.h>
#include <wheelrail/output/folder.h>
#include <wheelrail/output/replace_file.h>
#include <wheelrail/vehicle/creep_curve_command.h>
#include <wheelrail/wheel/given_distance.h>

#include <cstdio>
#include <filesystem>
#include <numeric>
#include <vector>

namespace wheelrail
{
  namespace
  {
    void
    print_table(const CreepCurve &curve, const FigureTable &table, std::ostream &out)
    {
      const bool spin  = curve.axis == CreepAxis::spin;
      const auto value = [&](const char *key, const std::size_t row) {
        const auto *const column = table.find(key);
        return column ? (*column)[row] : Summary::none;
      };
      out << "Forces on the wheel over the " << (spin ? "spin" : creep_axis_name(curve.axis) + " creepage")
          << " (in the contact plane)\n\n"
          << text("%12s %14s %14s %14s %12s %10s\n",
                  spin ? "spin" : "creepage",
                  "longitudinal",
                  "lateral",
                  "normal",
                  "spin moment",
                  "stick");
      out << text("%12s %14s %14s %14s %12s %10s\n", spin ? "1/m" : "%", "kN", "kN", "kN", "N m", "%");
      for (std::size_t row = 0; row < table.rows(); ++row)
        out << text("%12.4f %14.4f %14.4f %14.3f %12.3f %10.1f\n",
                    (spin ? 1 : 100) * curve.values[row],
                    1e-3 * value("longitudinal_force_N", row),
                    1e-3 * value("tangential_lateral_force_N", row),
                    1e-3 * value("normal_force_N", row),
                    value("reference_spin_moment_Nm", row),
                    100 * value("stick_fraction", row));
    }

    void
    add_abscissa(const CreepCurve &curve, const std::vector<double> &values, FigureTable &table)
    {
      if (curve.axis == CreepAxis::spin)
        table.add("given_spin_per_m", "1/m", values);
      else
        table.add("given_" + creep_axis_name(curve.axis) + "_creepage", "1", values);
    }

    double
    mean_of(const std::vector<double> &values)
    {
      return std::accumulate(values.begin(), values.end(), 0.) / values.size();
    }

    /// The points of another curve under the names of ours; tractions are shares of the normal force [N].
    FigureTable
    beside_table(const CreepCurve &curve, const MotionFile &other, const double normal_force)
    {
      using Q = MotionQuantity;
      FigureTable table;
      add_abscissa(curve, *other.find(curve.axis == CreepAxis::spin ? Q::spin : Q::creepage), table);
      const bool        along   = curve.axis == CreepAxis::longitudinal;
      const std::string force[] = {"longitudinal_force_N", "tangential_lateral_force_N"};
      if (const auto *const traction = other.find(Q::traction))
        {
          std::vector<double> values = *traction;
          for (double &value : values)
            value *= normal_force;
          table.add(force[along ? 0 : 1], "N", values);
        }
      if (const auto *const values = other.find(Q::longitudinal_force); values && !table.find(force[0]))
        table.add(force[0], "N", *values);
      if (const auto *const values = other.find(Q::lateral_force); values && !table.find(force[1]))
        table.add(force[1], "N", *values);
      if (const auto *const values = other.find(Q::spin_moment))
        table.add("reference_spin_moment_Nm", "Nm", *values);
      return table;
    }

    FigureTable
    table_of(const CreepCurve &curve, const std::vector<Summary> &points)
    {
      FigureTable table;
      add_abscissa(curve, curve.values, table);
      table.add_figures(
        split_list(
          "reference_creepage, reference_lateral_creepage, reference_spin_per_m, creepage, "
          "longitudinal_force_N, tangential_lateral_force_N, reference_spin_moment_Nm, normal_force_N, "
          "vertical_force_N, lateral_force_N, wheelset_longitudinal_force_N, wheelset_lateral_force_N, "
          "max_pressure_Pa, max_shear_traction_Pa, area_of_whole_elements_m2, stick_fraction, t_gamma_N"),
        points);
      return table;
    }
  } // namespace


  int
  run_creep_curve_command(const Scene         &scene,
                          const SceneGeometry *geometry,
                          const CreepCurve    &curve,
                          const std::string   &beside,
                          const bool           draws,
                          std::ostream        &out)
  {
    const ResultFolder           held(scene.folder, "-halfspace");
    const std::filesystem::path &folder = held.path();
    MotionFile                   other;
    if (!beside.empty())
      other = read_curve_file(
        beside, curve.axis == CreepAxis::spin ? MotionQuantity::spin : MotionQuantity::creepage);
    const bool given = distance_is_given(scene);
    TaskCount  count("points", curve.values.size(), 0, out);
    const auto points = solve_creep_curve(
      scene,
      curve,
      [&](const Scene &point) {
        return given ? solve_given_distance(point, geometry)
                     : solve_wheel_rail(point, *geometry, scene_load(point, *geometry), scene_offsets(point));
      },
      [&](const Scene &point, WheelRailSolution &result) {
        if (!given)
          hold_against_bodies(point, *geometry, result);
      },
      &count);

    std::vector<Summary> summaries;
    std::size_t          failed = 0;
    for (const WheelRailSolution &point : points)
      {
        summaries.push_back(halfspace_summary(scene, point));
        failed += summaries.back().finished ? 0 : 1;
      }
    FigureTable             table = table_of(curve, summaries);
    std::vector<double>     grades;
    std::vector<RowVerdict> verdicts;
    for (std::size_t row = 0; row < summaries.size(); ++row)
      {
        verdicts.push_back(
          {wheelrail::text("point %zu", row + 1), grade_of(summaries[row]), summaries[row].doubts});
        grades.push_back(static_cast<double>(verdicts.back().grade));
      }
    table.add("verdict", "1", grades);
    print_table(curve, table, out);
    print_row_verdicts(verdicts, "points", "verdict of creep_curve.csv", out);
    replace_file((folder / "parameters.prm").string(), print_parameters(scene));
    table.write_csv((folder / "creep_curve.csv").string());
    table.write_hdf5((folder / "creep_curve.h5").string());
    std::filesystem::remove(folder / "beside.csv");
    if (!beside.empty())
      beside_table(curve, other, mean_of(*table.find("normal_force_N")))
        .write_csv((folder / "beside.csv").string());
    if (failed > 0)
      out << failed << " of " << points.size() << " points could not be solved as they should; the first: " <<
        [&]() {
          for (const Summary &summary : summaries)
            if (!summary.finished)
              return summary.stop_reason;
          return std::string();
        }()
          << '\n';
    out << "Table in " << (folder / "creep_curve.csv").string() << std::endl;
    if (draws)
      draw_results("creep_curve.py", folder.string());
    return failed == 0 ? 0 : 2;
  }
} // namespace wheelrail
