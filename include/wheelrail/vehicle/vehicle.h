#pragma once

#include <wheelrail/input/motion_file.h>
#include <wheelrail/output/figure_table.h>
#include <wheelrail/scene/scene.h>
#include <wheelrail/vehicle/wheelset_contact.h>

#include <functional>
#include <string>
#include <vector>

namespace wheelrail
{
  class VehicleRows;

  /// The contact of one wheel over the rows of a motion.
  struct VehicleWheel
  {
    bool left = false;
    /// `largest_von_mises_Pa` is found for so many rows with the largest peak pressure.
    static constexpr std::size_t rows_with_stresses = 10;
    std::vector<Summary>     rows; ///< of each row as the command halfspace has it; forces of 0 without load
    std::vector<std::string> faults; ///< why a row has no figures, or is not to be trusted; empty: neither
  };

  /// The rows of the wheel that is modelled, or of both.
  struct VehicleResult
  {
    std::vector<VehicleWheel> wheels; ///< right before left
    std::vector<Summary>      axle;   ///< of both together, see axle_keys(); empty for one wheel
  };

  /// Solves the contacts of each row on all processors: of the modelled wheel, or with Wheelset/Wheels = both
  /// of the wheelset (solve_wheelset()). A row's torque is that of the axle, or of a wheel that turns by
  /// itself; there it gives the force along the wheelset over the rolling radius. A load of 0 is no contact;
  /// a row whose profiles do not touch has a fault and no figures, and does not stop the others. Rows that
  /// `kept` holds are not solved again, others are added to it. `report` is called for each row that was
  /// solved, from several threads.
  VehicleResult
  solve_vehicle(const Scene                 &scene,
                const WheelsetProfiles      &profiles,
                const MotionFile            &motion,
                VehicleRows                 *kept   = nullptr,
                const std::function<void()> &report = {});
} // namespace wheelrail
