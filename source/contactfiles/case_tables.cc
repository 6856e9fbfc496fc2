#include <wheelrail/base/format_text.h>
#include <wheelrail/contactfiles/case_tables.h>
#include <wheelrail/output/summary.h>

#include <cmath>
#include <cstddef>
#include <ostream>

namespace wheelrail
{
  FigureTable
  case_table(const std::vector<ContactCase> &cases, const std::vector<CaseResult> &results)
  {
    FigureTable table;
    table.add_columns(
      "case 1, line 1, normal_force_N N, longitudinal_force_N N, tangential_lateral_force_N N, "
      "spin_moment_Nm Nm, approach_m m, max_pressure_Pa Pa, max_shear_traction_Pa Pa, creepage 1, "
      "lateral_creepage 1, shift_m m, lateral_shift_m m, spin_per_m 1/m, area_of_whole_elements_m2 m2, "
      "stick_fraction 1, max_temperature_C C, converged 1");
    for (std::size_t k = 0; k < cases.size(); ++k)
      if (results[k].solved)
        {
          const HalfspaceSolution &s     = results[k].solved->solution;
          const bool               shift = cases[k].digits.motion == 1;
          const double             none  = Summary::none;
          table.add_row({double(k + 1),
                         double(cases[k].line),
                         s.fn,
                         s.fx,
                         s.fy,
                         s.spin_moment,
                         s.approach,
                         s.peak_pressure,
                         s.peak_shear,
                         shift ? none : s.xi,
                         shift ? none : s.eta,
                         shift ? s.xi : none,
                         shift ? s.eta : none,
                         shift ? none : s.phi,
                         s.area,
                         s.area > 0 ? s.adhesion_area / s.area : none,
                         hottest(s),
                         s.converged() ? 1. : 0.});
        }
    return table;
  }


  FigureTable
  point_table(const std::vector<CaseResult> &results)
  {
    FigureTable table;
    table.add_columns(
      "case 1, patch 1, block 1, x_m m, y_m m, z_m m, mean_stress_Pa Pa, von_mises_stress_Pa Pa, "
      "tresca_stress_Pa Pa, principal_1_Pa Pa, principal_2_Pa Pa, principal_3_Pa Pa, stress_xx_Pa Pa, "
      "stress_yy_Pa Pa, stress_zz_Pa Pa, stress_xy_Pa Pa, stress_xz_Pa Pa, stress_yz_Pa Pa");
    const auto add = [&](const std::size_t                            number,
                         const std::size_t                            patch,
                         const std::vector<std::vector<PointStress>> &blocks) {
      for (std::size_t b = 0; b < blocks.size(); ++b)
        for (const PointStress &p : blocks[b])
          table.add_row({double(number),
                         double(patch),
                         double(b + 1),
                         p.x,
                         p.y,
                         p.z,
                         p.mean(),
                         p.stress.von_mises(),
                         p.principal[0] - p.principal[2],
                         p.principal[0],
                         p.principal[1],
                         p.principal[2],
                         p.stress.xx,
                         p.stress.yy,
                         p.stress.nn,
                         p.stress.xy,
                         p.stress.xn,
                         p.stress.yn});
    };
    for (std::size_t k = 0; k < results.size(); ++k)
      if (results[k].solved)
        add(k + 1, 1, results[k].solved->points);
      else if (results[k].wheel_rail)
        for (std::size_t patch = 0; patch < results[k].wheel_rail->patches.size(); ++patch)
          add(k + 1, patch + 1, results[k].wheel_rail->patches[patch].points);
    return table;
  }


  FigureTable
  wheel_rail_table(const std::vector<ContactCase> &cases, const std::vector<CaseResult> &results)
  {
    FigureTable table;
    table.add_columns(
      "case 1, line 1, wheelset_height_m m, pitch_rate_rad_per_s rad/s, force_x_track_N N, force_y_track_N "
      "N, force_z_track_N N, force_x_wheelset_N N, force_y_wheelset_N N, force_z_wheelset_N N, patches 1, "
      "converged 1");
    for (std::size_t k = 0; k < cases.size(); ++k)
      if (results[k].wheel_rail)
        {
          const WheelRailCase &w = *results[k].wheel_rail;
          table.add_row({double(k + 1),
                         double(cases[k].line),
                         w.height,
                         w.pitch_rate,
                         w.force_track[0],
                         w.force_track[1],
                         w.force_track[2],
                         w.force_wheelset[0],
                         w.force_wheelset[1],
                         w.force_wheelset[2],
                         double(w.patches.size()),
                         w.not_reached.empty() ? 1. : 0.});
        }
    return table;
  }


  FigureTable
  patch_table(const std::vector<ContactCase> &cases, const std::vector<CaseResult> &results)
  {
    FigureTable table;
    table.add_columns(
      "case 1, patch 1, x_track_m m, y_track_m m, z_track_m m, contact_angle_rad rad, y_rail_m m, z_rail_m "
      "m, x_wheel_m m, y_wheel_m m, z_wheel_m m, reference_velocity_m_per_s m/s, creepage 1, "
      "lateral_creepage 1, spin_per_m 1/m, shift_m m, lateral_shift_m m, turn_rad rad, normal_force_N N, "
      "longitudinal_force_N N, tangential_lateral_force_N N, spin_moment_Nm Nm, approach_m m, "
      "max_pressure_Pa Pa, max_shear_traction_Pa Pa, area_of_whole_elements_m2 m2, stick_fraction 1, "
      "max_temperature_C C");
    for (std::size_t k = 0; k < cases.size(); ++k)
      if (results[k].wheel_rail)
        for (std::size_t n = 0; n < results[k].wheel_rail->patches.size(); ++n)
          {
            const WheelRailPatch    &p     = results[k].wheel_rail->patches[n];
            const HalfspaceSolution &s     = p.solution;
            const bool               shift = cases[k].digits.motion == 1;
            const double             none  = Summary::none;
            table.add_row({double(k + 1),
                           double(n + 1),
                           p.in_track[0],
                           p.in_track[1],
                           p.in_track[2],
                           p.angle,
                           p.on_rail[1],
                           p.on_rail[2],
                           p.on_wheel[0],
                           p.on_wheel[1],
                           p.on_wheel[2],
                           shift ? none : p.velocity,
                           shift ? none : p.creepage,
                           shift ? none : p.lateral_creepage,
                           shift ? none : p.spin,
                           shift ? p.creepage : none,
                           shift ? p.lateral_creepage : none,
                           shift ? p.spin : none,
                           p.normal_force,
                           s.fx,
                           p.lateral_force,
                           p.spin_moment,
                           s.approach,
                           s.peak_pressure,
                           s.peak_shear,
                           s.area,
                           s.area > 0 ? s.adhesion_area / s.area : none,
                           hottest(s)});
          }
    return table;
  }


  void
  print_case(const std::size_t place, const ContactCase &one, const HalfspaceSolution &s, std::ostream &out)
  {
    const bool   shift = one.digits.motion == 1;
    const double scale = shift ? 1e3 : 100; // shifts in mm, creepages in %
    // what is nothing beside the force that presses prints as nothing, as the solver leaves it
    const auto force = [&](const double value, const double unit) {
      return std::abs(value) < 1e-6 * s.fn * unit ? 0. : value;
    };
    out << text("%6zu %12.5g %12.5g %12.5g %12.5g %11.5f %11.5g %11.5f %11.5f %10.4g %8.1f\n",
                place,
                s.fn,
                force(s.fx, 1),
                force(s.fy, 1),
                1e3 * force(s.spin_moment, std::sqrt(s.area)),
                1e3 * s.approach,
                1e-6 * s.peak_pressure,
                scale * s.xi,
                scale * s.eta,
                1e6 * s.area,
                s.area > 0 ? 100 * s.adhesion_area / s.area : 0.);
  }

  void
  print_heading(std::ostream &out)
  {
    out << "Forces on body 1; creepages, or shifts in mm\n\n"
           "  case           FN           FX           FY           MZ    approach        peak        CKSI "
           "       CETA       area    stick\n"
           "                  N            N            N         N mm          mm         MPa           % "
           "          %        mm2        %\n";
  }


  void
  print_wheel_rail_heading(std::ostream &out)
  {
    out << "Forces on the rail; y to the right, z down; creepages, or shifts in mm\n\n"
           "  case      Z_WS      VPITCH     Y(TR)       angle          FN          FX          FS          "
           "MN  approach       peak     CKSI     CETA     area\n"
           "              mm       rad/s        mm        mrad           N           N           N        N "
           "mm        mm        MPa        %        %      mm2\n";
  }


  void
  print_wheel_rail(const std::size_t    place,
                   const ContactCase   &one,
                   const WheelRailCase &solved,
                   std::ostream        &out)
  {
    const double scale = one.digits.motion == 1 ? 1e3 : 100;
    for (const WheelRailPatch &p : solved.patches)
      out << text(
        "%6zu %9.4f %11.7f %9.3f %11.3f %11.5g %11.5g %11.5g %11.5g %9.5f %10.5g %8.4f %8.4f %8.2f\n",
        place,
        1e3 * solved.height,
        solved.pitch_rate,
        1e3 * p.in_track[1],
        1e3 * p.angle,
        p.normal_force,
        p.solution.fx,
        p.lateral_force,
        1e3 * p.spin_moment,
        1e3 * p.solution.approach,
        1e-6 * p.solution.peak_pressure,
        scale * p.creepage,
        scale * p.lateral_creepage,
        1e6 * p.solution.area);
    if (solved.patches.empty())
      out << text("%6zu %9.4f %11.7f  no contact\n", place, 1e3 * solved.height, solved.pitch_rate);
  }
} // namespace wheelrail
