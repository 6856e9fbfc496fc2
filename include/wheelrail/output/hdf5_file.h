#pragma once

#include <wheelrail/output/fields.h>

#include <cstdint>
#include <string>

namespace wheelrail
{
  /// Writes a history as an HDF5 file: one dataset per column under its name, all of one length,
  /// each with the text attribute `unit`. The whole file is rewritten into a temporary file and
  /// renamed, so that a reader finds a complete table at any time. To be called on one rank.
  /// Throws RunError when names, units and columns differ in number or the columns in length, or
  /// when the file cannot be written (with its name and the reason).
  void
  write_history(const History &history, const std::string &path);

  /// Reads a file of write_history() back; columns come in their original order. Throws RunError
  /// naming the file when it is missing or no such table.
  History
  read_history(const std::string &path);

  /// The contact patches of a run, one HDF5 group per tick: tick_0000, tick_0001, ... Each group
  /// has the attributes `time_s`, `rolled_distance_m`, `n_along`, `n_lateral` and each field as a
  /// dataset of n_along x n_lateral numbers with the attribute `unit` (names as in PatchFields).
  ///
  /// The file grows in memory and replaces the one on disk after each tick: a run that dies while
  /// it writes leaves the patches of all earlier ticks readable. To be used on one rank.
  class PatchFile
  {
  public:
    /// A new file `path`; nothing is written before the first append().
    explicit PatchFile(std::string path);

    /// With `resume`, starts from the ticks that `path` holds (if there is such a file) and keeps
    /// the first `keep_ticks` of them. Throws RunError when the file cannot be read.
    PatchFile(std::string path, bool resume, unsigned int keep_ticks);

    ~PatchFile();
    PatchFile(const PatchFile &) = delete;
    PatchFile &
    operator=(const PatchFile &) = delete;

    /// Adds one group and writes the file. Throws RunError when a field has another length than
    /// n_along x n_lateral, or when the file cannot be written.
    void
    append(const PatchFields &patch);

    unsigned int
    n_ticks() const
    {
      return n_ticks_;
    }

  private:
    std::string  path_;
    std::int64_t file_; ///< HDF5 identifier of the file in memory
    unsigned int n_ticks_ = 0;
  };

  /// Reads one tick of a file of PatchFile back; `tick` counts from 0. Throws RunError naming the
  /// file when it is missing or has no such tick.
  PatchFields
  read_patch(const std::string &path, unsigned int tick);
} // namespace wheelrail
