#pragma once

#include <wheelrail/sampling/run_parts.h>
#include <wheelrail/state/checkpoint.h>
#include <wheelrail/state/stop.h>

#include <string>

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

    /// Whether a state is kept: a run whose very first one is not finite has none.
    bool
    any() const
    {
      return any_;
    }

    /// Writes the kept state, unless there is none or it is on the disk already; gives its size [bytes].
    /// Collective; throws RunError on all ranks.
    double
    save();

    /// The same for a run that has stopped, with a note why, so that going on can be refused where it would
    /// only stop again. Collective; throws RunError on all ranks.
    double
    save(const Stop &stop);

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
    double      interval_;
    MPI_Comm    communicator_;
    Checkpoint  kept_;
    bool        any_ = false, on_disk_ = false; ///< whether a state is kept, and on the disk
    double      bytes_ = 0, last_end_ = 0, last_seconds_ = 0, saving_ = 0;
  };
} // namespace wheelrail
