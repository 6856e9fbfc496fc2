#pragma once

#include <wheelrail/input/motion_file.h>
#include <wheelrail/model/scene_geometry.h>
#include <wheelrail/output/figure_table.h>
#include <wheelrail/scene/scene.h>

#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace wheelrail
{
  /// The half-spaces of one wheel over the rows of a motion.
  struct VehicleWheel
  {
    bool left = false;
    /// `largest_von_mises_Pa` is found for the ten rows with the largest peak pressure.
    std::vector<Summary>     rows; ///< of each row as the command halfspace has it; forces of 0 without load
    std::vector<std::string> faults; ///< why a row has no figures, or is not to be trusted; empty: neither
  };

  /// What both wheels do together in a row, with the signs of AxleSolution; NaN in a row with a fault.
  struct AxleRow
  {
    static constexpr double none = std::numeric_limits<double>::quiet_NaN();

    double pitch_rate    = none; ///< [rad/s]
    double torque        = none; ///< that keeps the axle turning so [N m]
    double lateral_force = none; ///< sum on the wheels, positive to the left [N]
    double yaw_moment    = none; ///< of the contacts on the wheelset, positive turns its nose left [N m]
    double load          = none; ///< of the axle [N]
  };

  /// The rows of the wheel that is modelled, or of both.
  struct VehicleResult
  {
    std::vector<VehicleWheel> wheels; ///< right before left
    std::vector<AxleRow>      axle;   ///< with Wheelset/Axle = rigid; else empty
  };

  /// Solves the contacts of each row on all processors: of the modelled wheel, or of `both`, which turn at
  /// one rate (solve_axle()) unless Wheelset/Axle = independent. A row's torque is that of the axle, or of a
  /// wheel that turns by itself; there it gives the force along the wheelset over the rolling radius. A load
  /// of 0 is no contact; a row whose profiles do not touch has a fault and no figures, and does not stop the
  /// others. `report` is told how many rows are done, from several threads.
  VehicleResult
  solve_vehicle(const Scene                            &scene,
                const SceneProfiles                    &profiles,
                const MotionFile                       &motion,
                bool                                    both,
                const std::function<void(std::size_t)> &report);
} // namespace wheelrail
