#pragma once

#include <cstdint>
#include <functional>
#include <string>

namespace wheelrail
{
  /// An HDF5 file with one group per tick: tick_0000, tick_0001, ... It lives in memory and is written to
  /// the disk whole after each tick: a run that dies while it writes leaves all earlier ticks readable. To
  /// be used on one rank.
  class TickFile
  {
  public:
    /// A new file `path`; nothing is written before the first append(). With `resume`, starts from the
    /// ticks that `path` holds (if there is such a file) and keeps the first `keep_ticks` of them. Throws
    /// RunError when the file cannot be read.
    TickFile(std::string path, bool resume, unsigned int keep_ticks);

    ~TickFile();
    TickFile(const TickFile &) = delete;
    TickFile &
    operator=(const TickFile &) = delete;

    /// Adds one group with the attributes time_s and rolled_distance_m, has `fill` write into it (an HDF5
    /// identifier), and writes the file. Throws RunError when the file cannot be written.
    void
    append(double time, double rolled_distance, const std::function<void(std::int64_t)> &fill);

    unsigned int
    n_ticks() const
    {
      return n_ticks_;
    }
    const std::string &
    path() const
    {
      return path_;
    }

  private:
    std::string  path_;
    std::int64_t file_; ///< HDF5 identifier of the file in memory
    unsigned int n_ticks_ = 0;
  };

  /// "tick_0007".
  std::string
  tick_name(unsigned int tick);
} // namespace wheelrail
