#pragma once

#include <wheelrail/input/motion_file.h>
#include <wheelrail/vehicle/vehicle.h>

#include <cstddef>
#include <map>
#include <mutex>
#include <set>
#include <string>

namespace wheelrail
{
  /// Rows of a vehicle simulation that are kept in a file as soon as they are solved, so that a call that was
  /// interrupted, or killed, continues with the others and has the same results in the end.
  class VehicleRows
  {
  public:
    /// Reads what is kept in the file at `path`, if it is there. `digest`: of the scene (scene_digest()).
    /// Throws InputError where the file is of another scene or none of ours.
    VehicleRows(std::string path, std::string digest, const MotionFile &motion);

    /// How many rows are kept.
    std::size_t
    count() const
    {
      return kept_.size();
    }

    /// How many of them restore() does not solve again.
    std::size_t
    restored() const
    {
      return kept_.size() - solve_again_.size();
    }

    /// Puts a row that is kept into `vehicle`; false where it is not, or has to be solved again: stresses are
    /// found for rows with the largest pressures (VehicleResult), whose solutions are not kept.
    bool
    restore(std::size_t row, VehicleResult &vehicle) const;

    /// Adds a row of `vehicle` to the file; several threads may do so. Throws RunError when that cannot be
    /// written.
    void
    keep(std::size_t row, const VehicleResult &vehicle);

  private:
    const MotionFile                  &motion_;
    std::string                        path_, digest_;
    std::map<std::size_t, std::string> kept_;        ///< as the file has them
    std::set<std::size_t>              solve_again_; ///< those of the largest pressures
    std::mutex                         lock_;
  };
} // namespace wheelrail
