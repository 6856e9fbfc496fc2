#pragma once

#include <wheelrail/application/checkpoint.h>

namespace wheelrail
{
  /// Writes the checkpoint of all ranks into `folder` and gives its size on the disk [bytes].
  ///
  /// Every rank writes checkpoint_<k>_rank<r>.h5, k = 0 and 1 in turn, so that the last complete one
  /// stays; then rank 0 replaces checkpoint_last, a text that names k and the checksums of the files.
  /// Collective; throws RunError on all ranks when a file cannot be written.
  double
  write_checkpoint(const Checkpoint &checkpoint, const std::string &folder, MPI_Comm communicator);

  /// Reads what write_checkpoint() wrote last; `parameters` are the entries now in force.
  ///
  /// Collective; throws InputError on all ranks when the run in `folder` has finished, when there is
  /// no checkpoint, when it is from another number of ranks or another format, when a file is damaged
  /// (checksum), and when entries differ that the state depends on (all of them are named). Title,
  /// Output/Folder, Output/Volume fields, Run/Energy limit and Run/Averaging distance may differ.
  Checkpoint
  read_checkpoint(const std::string &folder, const std::string &parameters, MPI_Comm communicator);

  /// Removes all checkpoints from a folder. To be called on one rank.
  void
  remove_checkpoints(const std::string &folder);
} // namespace wheelrail
