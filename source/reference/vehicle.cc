#include <wheelrail/base/errors.h>
#include <wheelrail/base/parallel.h>
#include <wheelrail/reference/halfspace_case.h>
#include <wheelrail/reference/halfspace_stresses.h>
#include <wheelrail/reference/vehicle.h>
#include <wheelrail/reference/wheel_load.h>

#include <algorithm>
#include <atomic>
#include <mutex>
#include <optional>
#include <utility>

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

    /// Empty when the row has no load.
    std::optional<WheelRailSolution>
    solve_row(const Scene         &scene,
              const SceneProfiles &profiles,
              const MotionFile    &motion,
              const std::size_t    row)
    {
      const auto *const loads   = motion.find(MotionQuantity::load);
      const auto *const torques = motion.find(MotionQuantity::torque);
      if (loads && (*loads)[row] == 0)
        return {};
      const SceneGeometry geometry = make_geometry(scene, profiles);
      WheelRailLoad       load     = scene_load(scene, geometry);
      if (torques)
        {
          load.rate_held    = false;
          load.longitudinal = (*torques)[row] / geometry.contact.rolling_radius;
        }
      return solve_wheel_rail(scene, geometry, load, scene_offsets(scene));
    }

    /// The solutions of the rows with the largest peak pressures; several threads may hand in theirs.
    class Highest
    {
    public:
      struct Row
      {
        std::size_t       row;
        double            pressure;
        WheelRailSolution solution;
      };

      void
      hand_in(Row row)
      {
        const std::lock_guard<std::mutex> guard(lock_);
        rows_.push_back(std::move(row));
        if (rows_.size() > most)
          rows_.erase(std::min_element(
            rows_.begin(), rows_.end(), [](const Row &a, const Row &b) { return a.pressure < b.pressure; }));
      }

      const std::vector<Row> &
      rows() const
      {
        return rows_;
      }

    private:
      static constexpr std::size_t most = 10;
      std::mutex                   lock_;
      std::vector<Row>             rows_;
    };
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
      base.wheel_load = static_wheel_load(base, profiles.wheel);
    std::atomic<std::size_t> done{0};
    Highest                  highest;
    parallel_for(motion.rows(), [&](const std::size_t row) {
      Summary &summary = wheel.rows[row];
      try
        {
          const Scene at     = scene_at(base, motion, row);
          auto        result = solve_row(at, profiles, motion, row);
          summary            = result ? halfspace_summary(at, *result) : no_contact(at);
          wheel.faults[row]  = summary.finished ? "" : summary.stop_reason;
          if (result && summary.max_pressure > 0)
            highest.hand_in({row, summary.max_pressure, std::move(*result)});
        }
      catch (const InputError &error)
        {
          wheel.faults[row] = error.what();
        }
      report(++done);
    });

    // stresses below the patch take longer than the patch: of the rows with the largest pressures only
    parallel_for(highest.rows().size(), [&](const std::size_t i) {
      const HalfspaceStresses stresses = halfspace_stresses(highest.rows()[i].solution);
      set_figure(wheel.rows[highest.rows()[i].row],
                 "largest_von_mises_Pa",
                 std::max(stresses.surface_von_mises, stresses.subsurface_von_mises));
    });
    return wheel;
  }
} // namespace wheelrail
