#include <wheelrail/base/errors.h>
#include <wheelrail/base/parallel.h>
#include <wheelrail/reference/halfspace_case.h>
#include <wheelrail/reference/halfspace_stresses.h>
#include <wheelrail/reference/vehicle.h>
#include <wheelrail/reference/wheel_load.h>

#include <algorithm>
#include <atomic>

namespace wheelrail
{
  namespace
  {
    /// Without load there are no forces, and no place of a patch.
    Summary
    no_contact(const Scene &scene)
    {
      Summary summary;
      summary.finished           = true;
      summary.normal_force       = 0;
      summary.vertical_force     = 0;
      summary.longitudinal_force = 0;
      summary.lateral_force      = 0;
      summary.max_pressure       = 0;
      summary.max_shear_traction = 0;
      summary.contact_area       = 0;
      summary.velocity           = scene.velocity;
      for (const char *key : {"t_gamma_N",
                              "frictional_power_W",
                              "wheelset_longitudinal_force_N",
                              "wheelset_lateral_force_N",
                              "tangential_lateral_force_N",
                              "drive_torque_Nm",
                              "yaw_moment_Nm",
                              "reference_spin_moment_Nm",
                              "area_of_whole_elements_m2"})
        set_figure(summary, key, 0);
      return summary;
    }

    Summary
    solve_row(const Scene         &scene,
              const SceneProfiles &profiles,
              const MotionFile    &motion,
              const std::size_t    row,
              const bool           with_stresses)
    {
      const auto *const loads = motion.find(MotionQuantity::load), *const torques =
                                                                     motion.find(MotionQuantity::torque);
      if (loads && (*loads)[row] == 0)
        return no_contact(scene);
      const SceneGeometry geometry = make_geometry(scene, profiles);
      WheelRailLoad       load     = scene_load(scene, geometry);
      if (torques)
        {
          load.rate_held    = false;
          load.longitudinal = (*torques)[row] / geometry.contact.rolling_radius;
        }
      const WheelRailSolution result  = solve_wheel_rail(scene, geometry, load, scene_offsets(scene));
      Summary                 summary = halfspace_summary(scene, result);
      if (with_stresses)
        {
          const HalfspaceStresses stresses = halfspace_stresses(result);
          set_figure(summary,
                     "largest_von_mises_Pa",
                     std::max(stresses.surface_von_mises, stresses.subsurface_von_mises));
        }
      return summary;
    }
  } // namespace


  VehicleWheel
  solve_vehicle(const Scene                            &scene,
                const SceneProfiles                    &profiles,
                const MotionFile                       &motion,
                const bool                              left,
                const std::function<void(std::size_t)> &report)
  {
    VehicleWheel wheel{left, std::vector<Summary>(motion.rows()), std::vector<std::string>(motion.rows())};
    Scene        base = scene;
    base.left_wheel   = left;
    // the weight of the wheel is the same in all rows
    if (!motion.find(MotionQuantity::load))
      {
        Scene straight         = base;
        straight.lateral_shift = 0;
        straight.yaw           = 0;
        straight.roll          = RollMode::none;
        base.wheel_load        = static_wheel_load(straight, make_geometry(straight, profiles));
      }
    std::atomic<std::size_t> done{0};
    parallel_for(motion.rows(), [&](const std::size_t row) {
      Summary &summary = wheel.rows[row];
      try
        {
          summary           = solve_row(scene_at(base, motion, row), profiles, motion, row, false);
          wheel.faults[row] = summary.finished ? "" : summary.stop_reason;
        }
      catch (const InputError &error)
        {
          wheel.faults[row] = error.what();
        }
      report(++done);
    });

    // stresses below the patch take longer than the patch: of the rows with the largest pressures only
    std::vector<std::size_t> highest;
    for (std::size_t row = 0; row < motion.rows(); ++row)
      if (wheel.rows[row].max_pressure > 0)
        highest.push_back(row);
    const std::size_t some = std::min<std::size_t>(highest.size(), 10);
    std::partial_sort(
      highest.begin(), highest.begin() + some, highest.end(), [&](const auto a, const auto b) {
        return wheel.rows[a].max_pressure > wheel.rows[b].max_pressure;
      });
    parallel_for(some, [&](const std::size_t i) {
      wheel.rows[highest[i]] =
        solve_row(scene_at(base, motion, highest[i]), profiles, motion, highest[i], true);
    });
    return wheel;
  }
} // namespace wheelrail
