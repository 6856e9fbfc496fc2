#include <wheelrail/base/format_text.h>
#include <wheelrail/base/parallel.h>
#include <wheelrail/bodies/answering_bodies.h>
#include <wheelrail/bodies/shift_effect.h>
#include <wheelrail/vehicle/vehicle.h>
#include <wheelrail/vehicle/vehicle_rows.h>
#include <wheelrail/vehicle/wheelset_contact.h>
#include <wheelrail/vehicle/wheelset_figures.h>
#include <wheelrail/verdict/verdict.h>
#include <wheelrail/wheel/halfspace_case.h>
#include <wheelrail/wheel/halfspace_stresses.h>
#include <wheelrail/wheel/noise_effect.h>
#include <wheelrail/wheel/wheel_load.h>

#include <algorithm>
#include <limits>
#include <mutex>
#include <optional>
#include <utility>

namespace wheelrail
{
  namespace
  {
    /// Without load there are no forces, and no place of a patch; where the row has a load, the curve lifts
    /// the wheel.
    Summary
    no_contact(const Scene &scene)
    {
      Summary summary;
      if (scene.wheel_load > 0)
        {
          summary.verdict = grade_word(Grade::with_care);
          summary.doubts  = lifted_by_curve(scene.left_wheel);
        }
      summary.finished           = true;
      summary.normal_force       = 0;
      summary.vertical_force     = 0;
      summary.longitudinal_force = 0;
      summary.lateral_force      = 0;
      summary.max_pressure       = 0;
      summary.max_shear_traction = 0;
      summary.contact_area       = 0;
      summary.velocity           = scene.velocity;
      for (const std::string &key :
           split_list("t_gamma_N, frictional_power_W, wheelset_longitudinal_force_N, "
                      "wheelset_lateral_force_N, tangential_lateral_force_N, drive_torque_Nm, yaw_moment_Nm, "
                      "reference_spin_moment_Nm, area_of_whole_elements_m2"))
        set_figure(summary, key, 0);
      return summary;
    }

    /// The scene at a row for one of the wheels.
    Scene
    wheel_of_row(const Scene &scene, const MotionFile &motion, const std::size_t row, const bool left)
    {
      return scene_at(wheel_of_wheelset(scene, left), of_wheel(motion, left), row);
    }

    /// A torque of the row, or nothing.
    std::optional<double>
    torque_of(const MotionFile &motion, const std::size_t row)
    {
      const auto *const torques = motion.find(MotionQuantity::torque);
      return torques ? std::optional<double>((*torques)[row]) : std::nullopt;
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
        if (rows_.size() > VehicleWheel::rows_with_stresses)
          rows_.erase(std::min_element(
            rows_.begin(), rows_.end(), [](const Row &a, const Row &b) { return a.pressure < b.pressure; }));
      }

      const std::vector<Row> &
      rows() const
      {
        return rows_;
      }

    private:
      std::mutex       lock_;
      std::vector<Row> rows_;
    };

    /// The figures of a wheel from its solution of a row.
    Summary
    figures_of(const std::optional<WheelRailSolution> &result,
               const WheelOnAxle                      &wheel,
               const double                            rate,
               const std::optional<double>            &torque)
    {
      if (!result)
        return no_contact(wheel.scene);
      Summary figures = halfspace_summary(wheel.scene, *result);
      if (wheel.scene.halfspace_bodies == ContactBodies::real)
        add_halfspaces(wheel.scene, wheel.geometry, load_of_wheel(wheel, rate, torque), figures);
      return figures;
    }

    /// Stresses below the patch take longer than the patch: of the rows with the largest pressures only.
    void
    add_stresses(const Highest &highest, VehicleWheel &wheel)
    {
      parallel_for(highest.rows().size(), [&](const std::size_t i) {
        const HalfspaceStresses stresses = halfspace_stresses(highest.rows()[i].solution);
        set_figure(wheel.rows[highest.rows()[i].row],
                   "largest_von_mises_Pa",
                   std::max(stresses.surface_von_mises, stresses.subsurface_von_mises));
      });
    }

    /// The contacts of one row, into the row of `vehicle`; those with the highest pressure so far are handed
    /// to `highest`.
    void
    solve_row(const Scene            &base,
              const WheelsetProfiles &profiles,
              const MotionFile       &motion,
              const std::size_t       row,
              VehicleResult          &vehicle,
              std::vector<Highest>   &highest)
    {
      const std::optional<double> torque = torque_of(motion, row);
      Scene                       own    = base; // its bodies are those that answer in this row
      const auto                  keep   = [&](const std::size_t                side,
                            const WheelOnAxle               &wheel,
                            const double                     rate,
                            std::optional<WheelRailSolution> result) {
        if (result)
          {
            hold_against_bodies(wheel.scene, wheel.geometry, *result);
            find_noise_effect(wheel.scene, wheel.geometry, *result);
          }
        Summary &figures                 = vehicle.wheels[side].rows[row];
        figures                          = figures_of(result, wheel, rate, torque);
        vehicle.wheels[side].faults[row] = figures.finished ? "" : figures.stop_reason;
        if (const double peak = figures.max_pressure; result && peak > 0)
          highest[side].hand_in({row, peak, std::move(*result)});
      };
      const auto solve = [&]() {
        if (base.both_wheels)
          {
            WheelsetSolution wheelset = solve_wheelset(
              wheel_of_row(own, motion, row, false), wheel_of_row(own, motion, row, true), profiles, torque);
            set_axle_figures(wheelset, vehicle.axle[row]);
            keep(0, wheelset.right, wheelset.axle.rate, std::move(wheelset.axle.right));
            keep(1, wheelset.left, wheelset.axle.rate, std::move(wheelset.axle.left));
            return;
          }
        const bool        left = vehicle.wheels[0].left;
        const Scene       at   = wheel_of_row(own, motion, row, left);
        const WheelOnAxle wheel{at, make_geometry(at, left ? profiles.left : profiles.right), at.wheel_load};
        keep(0, wheel, std::numeric_limits<double>::quiet_NaN(), solve_alone(wheel, torque));
      };
      std::string       note;
      const std::string fault = fault_of([&]() { note = solve_with_bodies(own, solve); });
      for (VehicleWheel &wheel : vehicle.wheels)
        {
          if (!fault.empty())
            wheel.faults[row] = fault;
          if (!note.empty())
            wheel.rows[row].note = note;
        }
    }
  } // namespace


  VehicleResult
  solve_vehicle(const Scene                 &scene,
                const WheelsetProfiles      &profiles,
                const MotionFile            &motion,
                VehicleRows                 *kept,
                const std::function<void()> &report)
  {
    const bool        both = scene.both_wheels;
    VehicleResult     vehicle;
    std::vector<bool> sides = both ? std::vector<bool>{false, true} : std::vector<bool>{scene.left_wheel};
    for (const bool left : sides)
      vehicle.wheels.push_back(
        {left, std::vector<Summary>(motion.rows()), std::vector<std::string>(motion.rows())});
    vehicle.axle.resize(both ? motion.rows() : 0);
    // the weight of the wheel is the same in all rows
    Scene base      = scene;
    base.wheel_load = static_wheel_load(base, profiles.right.wheel);
    std::vector<Highest> highest(sides.size());
    parallel_for(motion.rows(), [&](const std::size_t row) {
      if (kept && kept->restore(row, vehicle))
        return;
      solve_row(base, profiles, motion, row, vehicle, highest);
      if (kept)
        kept->keep(row, vehicle);
      if (report)
        report();
    });
    for (std::size_t side = 0; side < sides.size(); ++side)
      add_stresses(highest[side], vehicle.wheels[side]);
    return vehicle;
  }
} // namespace wheelrail
