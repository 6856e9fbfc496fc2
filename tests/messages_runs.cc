// ranks: 1 2
// What the program answers to unsuitable output folders and saved states, word by word and the same
// on all ranks.

#include "messages.h"

#include <wheelrail/output/folder.h>
#include <wheelrail/state/checkpoint_files.h>

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
    write("runs/done/summary.json", "{\"finished\": true}");
    check_folder("runs/done",
                 "Output/Folder = runs/done: the folder holds a finished run, which is kept. Choose another "
                 "Output/Folder, or give --overwrite to replace it.");
    check_folder(
      "/proc/below",
      "Output/Folder = /proc/below: the folder cannot be made: No such file or directory. Choose a "
      "place in which you may write.");
    check(!fs::exists("runs/foreign/parameters.prm"), "and nothing was written there");
    // a folder of the kernel, in which not even root can make files
    check_folder("/proc",
                 "Output/Folder = /proc: no files can be made there. The output file "
                 "\"/proc/.wheelrail-write-test\" cannot be written: No such file or "
                 "directory. Check that the folder still exists and may be written to.");
  }

  const std::string parameters =
    "set Title = x\nsubsection Run\n  set Rolling distance = 30 mm\nend\n"
    "subsection Wheelset\n  set Velocity = 140 km/h\nend\n";

  /// What --resume answers in runs/saved for a scene with these entries and this distance [m].
  std::string
  answer(const std::string &entries, const double distance = 0.03)
  {
    Scene scene;
    scene.folder           = "runs/saved";
    scene.rolling_distance = distance;
    return message_of([&]() { read_checkpoint(scene, entries, MPI_COMM_WORLD); });
  }

  void
  check_state(const std::string &found, const std::string &expected)
  {
    check_text(found, "--resume, Output/Folder = runs/saved: " + expected, expected);
  }

  /// A state without nodes that has rolled 10 mm on a mesh for 30 mm.
  Checkpoint
  small_state()
  {
    Checkpoint state;
    state.parameters                   = parameters;
    state.prepared_distance            = 0.03;
    state.axle.travelled               = 0.01;
    state.works["viscous_dissipation"] = {0.};
    return state;
  }

  void
  test_differences()
  {
    check_text(answer(parameters), "no message", "a state of the same entries is read");
    check_state(
      answer("set Title = y\nsubsection Run\n  set Rolling distance = 20 mm\nend\n"
             "subsection Wheelset\n  set Velocity = 100 km/h\nend\n"),
      "entries differ from those of the saved state, which must not change: Wheelset/Velocity = 100 "
      "km/h, saved with 140 km/h; set them back, or start anew in another Output/Folder");
    check_state(answer("set Title = y\n"),
                "entries differ from those of the saved state, which must not change: Wheelset/Velocity = "
                "(not there), saved with 140 km/h; set them back, or start anew in another Output/Folder");
    check_state(
      answer(parameters, 0.04),
      "Run/Rolling distance = 40 mm: the mesh of the saved state was made for 30 mm of rolling; give "
      "at most that, or start anew with Mesh/Prepared distance = 40 mm");
    check_state(answer(parameters, 0.01),
                "Run/Rolling distance = 10 mm: the saved state has rolled 10 mm; give more than that, and at "
                "most 30 mm");
  }

  /// With the newest state damaged, the one before it is read, and a note says so.
  void
  test_older_state(const std::string &damaged)
  {
    write_checkpoint(small_state(), "runs/saved", MPI_COMM_WORLD); // checkpoint_1.h5
    write_checkpoint(small_state(), "runs/saved", MPI_COMM_WORLD); // checkpoint_0.h5
    write("runs/saved/checkpoint_0.h5", "damaged");
    Scene scene;
    scene.folder           = "runs/saved";
    scene.rolling_distance = 0.03;
    const auto  point      = read_checkpoint(scene, parameters, MPI_COMM_WORLD);
    std::string notes;
    for (const std::string &note : point->notes)
      notes += note + "\n";
    check_text(notes,
               damaged + "; the run goes on from the state before it, checkpoint_1.h5\n",
               "the older of two states");
  }

  void
  test_saved_states()
  {
    const std::string anew = "; start anew without --resume";
    check_state(answer(parameters), "there is no run to go on with; start without --resume");
    write("runs/saved/summary.json", "{\"finished\": true}");
    check_state(answer(parameters), "the run in this folder has finished; there is nothing to go on with");
    write("runs/saved/summary.json", "{\"finished\": false}");
    write("runs/saved/checkpoint.json", "{\"format\": 1}");
    check_state(answer(parameters),
                "checkpoint.json is of format 1, this version of the program reads format 3" + anew);
    write("runs/saved/checkpoint.json", "no JSON");
    check_state(answer(parameters),
                "checkpoint.json is of format \"none\", this version of the program reads format 3" + anew);
    write("runs/saved/checkpoint.json", "{\"format\": 3}");
    check_state(answer(parameters), "checkpoint.json lists no saved state" + anew);

    write_checkpoint(small_state(), "runs/saved", MPI_COMM_WORLD);
    test_differences();
    const std::string damaged =
      "checkpoint_0.h5 is damaged or missing (its checksum is not the one in checkpoint.json)";
    write("runs/saved/checkpoint_0.h5", "damaged");
    check_state(answer(parameters), damaged + anew);
    test_older_state(damaged);
    write_checkpoint(small_state(), "runs/saved", MPI_COMM_WORLD);
    write("runs/saved/checkpoint_1.h5", "damaged");
    check_state(answer(parameters),
                "checkpoint_1.h5 is damaged or missing (its checksum is not the one in checkpoint.json); " +
                  damaged + anew);
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
