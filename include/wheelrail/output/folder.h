#pragma once

#include <mpi.h>

#include <string>

namespace wheelrail
{
  /// What to do with a folder that holds an earlier run.
  enum class FolderMode
  {
    fresh,     ///< refuse the folder of a finished run; start an unfinished one anew
    overwrite, ///< start anew, also where a run finished
    resume     ///< keep all files: the run goes on
  };

  /// Makes `folder` (and the folders above it) ready for a run and writes into it input.prm (`input`, the
  /// text as the user gave it) and parameters.prm (`parameters`, all entries in force). When a run
  /// starts anew in the folder of an earlier one (known by its parameters.prm), the program's own
  /// files there are removed first; other files are never touched.
  ///
  /// Collective over `comm`, done by rank 0. Throws InputError on all ranks, with nothing made or
  /// changed: when `folder` holds a finished run and the mode is fresh, when something on the path is
  /// no folder, when there are no rights to write.
  void
  prepare_folder(const std::string &folder,
                 FolderMode         mode,
                 const std::string &input,
                 const std::string &parameters,
                 MPI_Comm           comm);

  /// Whether `folder` holds a run that reached its end (summary.json says finished).
  bool
  holds_finished_run(const std::string &folder);
} // namespace wheelrail
