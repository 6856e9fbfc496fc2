#pragma once

#include <wheelrail/sampling/run_parts.h>
#include <wheelrail/state/checkpoint.h>

namespace wheelrail
{
  /// Keeps the last good state of a run in memory and writes it to the disk from time to time.
  class SavedStates
  {
  public:
    /// `interval` between two states on the disk [s]; 0: one minute, or a hundred times what the last one
    /// took when that is longer, so that they cost less than 1 % of the run.
    SavedStates(const Scene &scene, std::string parameters, double interval, MPI_Comm communicator);

    /// Copies the state of the moment, with the number of ticks written and the wall time [s] so far; a
    /// state with a value that is not finite is not kept. Collective.
    void
    keep(const RunParts &run, unsigned int ticks, double wall_time);

    /// Whether it is time to keep and save a state. Collective.
    bool
    due() const;

    /// Writes the kept state, unless it is on the disk already; gives its size [bytes]. Collective; throws
    /// RunError on all ranks.
    double
    save();

    /// The rank's part of the state kept last.
    const Checkpoint &
    kept() const
    {
      return kept_;
    }
    /// Seconds spent in save() so far.
    double
    seconds_saving() const
    {
      return saving_;
    }

  private:
    std::string folder_, parameters_;
    double      prepared_distance_, interval_;
    MPI_Comm    communicator_;
    Checkpoint  kept_;
    bool        on_disk_ = false; ///< the kept state
    double      bytes_ = 0, last_end_ = 0, last_seconds_ = 0, saving_ = 0;
  };
} // namespace wheelrail
