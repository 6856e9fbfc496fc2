#pragma once

#include <wheelrail/state/checkpoint.h>
#include <wheelrail/state/stop.h>

#include <optional>
#include <string>
#include <vector>

namespace wheelrail
{
  /// Gathers the parts of all ranks and writes them into `folder`; gives the size on the disk [bytes].
  ///
  /// checkpoint_0.h5 and checkpoint_1.h5 are written in turn, so that the last complete one stays; then
  /// checkpoint.json is replaced, which names both, the newest first, with distance, time, ranks, version,
  /// size and checksum. Collective; throws RunError on all ranks when a file cannot be written.
  double
  write_checkpoint(const Checkpoint &part, const std::string &folder, MPI_Comm communicator);

  /// Notes beside the saved states in `folder` why the run stopped; the next state that is written removes
  /// the note. Without saved states nothing is written. To be called on one rank; throws RunError.
  void
  write_stop(const Stop &stop, const std::string &folder);

  /// Throws InputError when `folder` holds saved states of a run that has not finished, which a new start
  /// would remove. To be called on one rank.
  void
  protect_saved_states(const std::string &folder);

  /// The state a run goes on from, and what the user should know about it.
  struct ResumePoint
  {
    Checkpoint               whole;
    std::vector<std::string> notes; ///< sentences: an older state was taken, other ranks, other version
  };

  /// Reads the newest whole state in the folder of `scene`; `parameters` are the entries now in force.
  /// Nothing when the run in the folder was ended before it had saved a state.
  ///
  /// A file that is missing or does not fit its checksum is passed over for the other one, with a note.
  /// Collective; throws InputError on all ranks when the run in the folder has finished, when there is no
  /// run, when it stopped before it had saved a state, when no state is whole, when it is of another format,
  /// when entries differ that the state depends on (all of them are named), and when the run would only stop
  /// again where it stopped (see obstacle_of_stop()). Title, all entries of Output and Half-space, Run/Energy
  /// limit, Run/Averaging distance may differ, and Run/Rolling distance as far as the mesh was made for it.
  std::optional<ResumePoint>
  read_checkpoint(const Scene &scene, const std::string &parameters, MPI_Comm communicator);

  /// Removes all checkpoints from a folder. To be called on one rank.
  void
  remove_checkpoints(const std::string &folder);
} // namespace wheelrail
