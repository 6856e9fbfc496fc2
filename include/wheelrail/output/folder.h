#pragma once

#include <mpi.h>

#include <filesystem>
#include <memory>
#include <string>

namespace wheelrail
{
  class FolderLock;

  /// What to do with a folder that holds an earlier run.
  enum class FolderMode
  {
    fresh,     ///< refuse the folder of a finished run
    overwrite, ///< start anew, also where a run finished
    resume     ///< go on with the run
  };

  /// An output folder, held for one run from the constructor to the destructor, see FolderLock.
  class OutputFolder
  {
  public:
    /// Makes `folder` (and the folders above it) and holds it; nothing in it is changed yet. `input` is the
    /// parameter file as the user gave it.
    ///
    /// Collective over `communicator`, done by rank 0. Throws InputError on all ranks, with nothing made or
    /// changed: when `folder` holds a finished run and the mode is fresh, when another run works in it, when
    /// it holds another input.prm, when something on the path is no folder, when there are no rights to
    /// write.
    OutputFolder(std::string folder, FolderMode mode, std::string input, MPI_Comm communicator);

    /// Lets go; folders that were made are removed again when begin() has not been called.
    ~OutputFolder();

    OutputFolder(const OutputFolder &) = delete;
    OutputFolder &
    operator=(const OutputFolder &) = delete;

    /// Writes input.prm and parameters.prm (`parameters`, all entries in force). Unless `keep`, with which a
    /// run goes on, the program's own files of an earlier run (known by its parameters.prm) are removed
    /// first, and input.prm is replaced; other files are never touched. Collective; throws RunError on all
    /// ranks.
    void
    begin(const std::string &parameters, bool keep);

  private:
    std::string                 folder_, input_;
    MPI_Comm                    communicator_;
    std::unique_ptr<FolderLock> lock_; ///< on rank 0 only
    std::filesystem::path       made_; ///< the topmost folder that was made, while begin() may still fail
  };

  /// Whether `folder` holds a run that reached its end (summary.json says finished).
  bool
  holds_finished_run(const std::string &folder);

  /// Throws InputError where `folder` cannot be one: something above it, or it itself, is a file.
  void
  require_possible_folder(const std::string &folder);

  /// The folder for results that are no run's, beside that of a scene's run: "output/rolling" and
  /// "-halfspace" give "output/rolling-halfspace".
  std::filesystem::path
  folder_beside(const std::string &folder, const std::string &tail);

  /// Such a folder, made where it is not there, and held by this process (FolderLock) to the end of its
  /// results. Throws InputError as OutputFolder does.
  class ResultFolder
  {
  public:
    ResultFolder(const std::string &folder, const std::string &tail);

    /// Lets go; folders that were made and are empty are removed again: bad input leaves none.
    ~ResultFolder();

    ResultFolder(const ResultFolder &) = delete;
    ResultFolder &
    operator=(const ResultFolder &) = delete;

    const std::filesystem::path &
    path() const
    {
      return path_;
    }

  private:
    std::filesystem::path       path_, made_;
    std::unique_ptr<FolderLock> lock_;
  };

  /// Removes what an earlier call wrote into a folder of the program's own (known by its parameters.prm), and
  /// into those of its wheels: a solution of one wheel and one of a wheelset have other files, and a page
  /// would show both. Tables of creep curves and places stay, as do other files.
  void
  remove_earlier_results(const std::filesystem::path &folder);
} // namespace wheelrail
