// ranks: 1 2
// What the program answers to unsuitable output folders and saved states, word by word and the same
// on all ranks.

#include "messages.h"

#include <wheelrail/application/checkpoint_files.h>
#include <wheelrail/output/folder.h>

#include <deal.II/base/mpi.h>

#include <filesystem>
#include <fstream>

using namespace wheelrail;
using test::check;
using test::check_text;
using test::message_of;

namespace
{
  namespace fs = std::filesystem;

  int
  rank()
  {
    return dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD);
  }

  int
  ranks()
  {
    return dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD);
  }

  void
  write(const std::string &path, const std::string &text)
  {
    if (rank() == 0)
      {
        fs::create_directories(fs::path(path).parent_path());
        std::ofstream(path) << text;
      }
    MPI_Barrier(MPI_COMM_WORLD);
  }

  void
  check_folder(const std::string &folder, const std::string &expected)
  {
    check_text(message_of([&]() {
                 prepare_folder(
                   folder, FolderMode::fresh, "set Title = x\n", "set Title = x\n", MPI_COMM_WORLD);
               }),
               expected,
               expected);
  }

  void
  test_folders()
  {
    write("runs/file", "a file");
    write("runs/foreign/input.prm", "set Title = mine\n");
    const std::string here = fs::current_path().string();
    check_folder("", "Output/Folder is empty; give the name of a folder, such as output/rolling.");
    check_folder("runs/file",
                 "Output/Folder = runs/file: \"" + here +
                   "/runs/file\" is a file, where a folder is needed. Choose another name.");
    check_folder("runs/file/below",
                 "Output/Folder = runs/file/below: \"" + here +
                   "/runs/file\" is a file, where a folder is needed. Choose another name.");
    check_folder("runs/foreign",
                 "Output/Folder = runs/foreign: the folder holds another input.prm, which the copy of this "
                 "input would replace. Choose another Output/Folder, or rename that file.");
    check(!fs::exists("runs/foreign/parameters.prm"), "and nothing was written there");
    // a folder of the kernel, in which not even root can make files
    check_folder("/proc",
                 "Output/Folder = /proc: no files can be made there. The output file "
                 "\"/proc/.wheelrail-write-test\" cannot be written: No such file or "
                 "directory. Check that the folder still exists and may be written to.");
  }

  void
  check_state(const std::string &parameters, const std::string &expected)
  {
    check_text(
      message_of([&]() { read_checkpoint("runs/saved", parameters, MPI_COMM_WORLD); }), expected, expected);
  }

  void
  test_saved_states()
  {
    const std::string parameters = "set Title = x\nsubsection Run\n  set Rolling distance = 30 mm\nend\n";
    const std::string folder     = "--resume, Output/Folder = runs/saved: ";
    check_state(parameters, folder + "there is no saved state to go on from; start without --resume");
    write("runs/saved/summary.json", "{\"finished\": true}");
    check_state(parameters, folder + "the run in this folder has finished; there is nothing to go on with");
    write("runs/saved/summary.json", "{\"finished\": false}");
    write("runs/saved/checkpoint_last", "format = 0\n");
    check_state(parameters,
                folder +
                  "the state was saved in format \"0\", this version of the program reads format 1; start "
                  "anew without --resume");

    Checkpoint checkpoint;
    checkpoint.parameters = parameters;
    if (rank() == 0)
      fs::remove("runs/saved/checkpoint_last");
    write_checkpoint(checkpoint, "runs/saved", MPI_COMM_WORLD);
    check_text(message_of([&]() { read_checkpoint("runs/saved", parameters, MPI_COMM_WORLD); }),
               "no message",
               "a state of the same entries is read");
    check_state("set Title = y\nsubsection Run\n  set Rolling distance = 40 mm\nend\n",
                folder +
                  "entries differ from those of the saved state, which must not change: Run/Rolling "
                  "distance = 40 mm, saved with 30 mm");
    write("runs/saved/checkpoint_0_rank0.h5", "damaged");
    check_state(parameters,
                folder +
                  "runs/saved/checkpoint_0_rank0.h5 is damaged or missing (its checksum is not the one in "
                  "checkpoint_last); start anew without --resume");
    write("runs/saved/checkpoint_last", "format = 1\nfiles = checkpoint_0\nranks = 7\n");
    check_state(parameters,
                folder + "the state was saved by 7 ranks and goes on with the same number only, not with " +
                  std::to_string(ranks()) + "; give --ranks 7");
  }
} // namespace

int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  if (rank() == 0)
    fs::remove_all("runs");
  MPI_Barrier(MPI_COMM_WORLD);
  test_folders();
  test_saved_states();
  MPI_Barrier(MPI_COMM_WORLD);
  if (rank() == 0)
    fs::remove_all("runs");
  return test::report();
}
