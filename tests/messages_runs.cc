// ranks: 1 2
// What the program answers to unsuitable output folders and saved states, word by word and the same
// on all ranks.

#include "messages.h"
#include "parallel.h"

#include <wheelrail/input/listing.h>
#include <wheelrail/output/folder.h>
#include <wheelrail/state/checkpoint_checks.h>
#include <wheelrail/state/checkpoint_files.h>

#include <deal.II/base/mpi.h>

#include <filesystem>
#include <fstream>
#include <regex>

#include <unistd.h>

using namespace wheelrail;
using test::message_of;
using test::same_text;

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
    BOOST_TEST(same_text(message_of([&]() {
                           OutputFolder(folder, FolderMode::fresh, "set Title = x\n", MPI_COMM_WORLD)
                             .begin("set Title = x\n", false);
                         }),
                         expected,
                         expected));
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
    BOOST_TEST(!fs::exists("runs/foreign/parameters.prm"), "and nothing was written there");
    // a folder of the kernel, in which not even root can make files
    check_folder("/proc",
                 "Output/Folder = /proc: no files can be made there. The output file "
                 "\"/proc/run.lock\" cannot be written: No such file or "
                 "directory. Check that the folder still exists and may be written to.");
  }

  /// The file of a run that is gone, or may be.
  std::string
  holder(const std::string &host, const std::string &boot, const long process)
  {
    return "{\"host\": \"" + host + "\", \"boot\": \"" + boot +
           "\", \"process\": " + std::to_string(process) + "}";
  }

  void
  test_locks()
  {
    const std::string lock = "runs/held/run.lock";
    char              host[256];
    gethostname(host, sizeof host);
    std::string boot;
    std::getline(std::ifstream("/proc/sys/kernel/random/boot_id") >> std::ws, boot);
    for (const std::string &left : {std::string(),
                                    std::string("no JSON"),
                                    holder(host, boot, 1),
                                    holder("another", boot, 1), // a container's name for this machine
                                    holder(host, "before", 1)})
      {
        write(lock, left);
        check_folder("runs/held", "no message");
        MPI_Barrier(MPI_COMM_WORLD); // the first rank removes the lock when its folder goes
        BOOST_TEST(!fs::exists(lock), "what a killed run left is taken over: " + left);
        MPI_Barrier(MPI_COMM_WORLD);
      }
    write(lock, holder("another", "before", 17));
    check_folder(
      "runs/held",
      "Output/Folder = runs/held: a run on another machine works in this folder, process 17 on "
      "another, or was ended there without a word. Choose another Output/Folder, or, when it is gone, "
      "remove \"runs/held/run.lock\".");
    BOOST_TEST(fs::exists(lock), "another machine's lock stays");
    MPI_Barrier(MPI_COMM_WORLD);
    write(lock, "");
    const OutputFolder held("runs/held", FolderMode::overwrite, "", MPI_COMM_WORLD);
    const std::string  found =
      message_of([]() { OutputFolder("runs/held", FolderMode::overwrite, "", MPI_COMM_WORLD); });
    BOOST_TEST(same_text(std::regex_replace(found, std::regex("process [0-9]+ on"), "process N on"),
                         "Output/Folder = runs/held: another run works in this folder, process N on " +
                           std::string(host) + ". Wait for its end, or choose another Output/Folder.",
                         "a folder that is held"));
  }

  const std::string parameters =
    "set Title = x\nsubsection Run\n  set Rolling distance = 30 mm\nend\n"
    "subsection Wheelset\n  set Velocity = 140 km/h\nend\n";

  /// What --resume answers in runs/saved for a scene with these entries and this distance [m].
  std::string
  answer(const std::string &entries,
         const double       distance = 0.03,
         const MeshWindow   window   = MeshWindow::fixed,
         const std::string &rail     = "54E1")
  {
    Scene scene;
    scene.rail_profile     = rail;
    scene.folder           = "runs/saved";
    scene.rolling_distance = distance;
    scene.window           = window;
    return message_of([&]() { read_checkpoint(scene, entries, MPI_COMM_WORLD); });
  }

  void
  check_state(const std::string &found, const std::string &expected)
  {
    BOOST_TEST(same_text(found, "--resume, Output/Folder = runs/saved: " + expected, expected));
  }

  /// A state without nodes that has rolled 10 mm on a mesh for 30 mm.
  Checkpoint
  small_state()
  {
    Checkpoint state;
    state.parameters                   = parameters;
    state.prepared_distance            = 0.03;
    state.longest_distance             = 0.03;
    state.rolling.parts["axle"]        = {{{"travelled", 0.01}}, {}, {}};
    state.works["viscous_dissipation"] = {0.};
    return state;
  }

  void
  test_differences()
  {
    Scene driven; // by the default of an earlier version
    driven.traction_coefficient = 0.25;
    BOOST_TEST(same_text(other_entries(print_parameters(driven), print_parameters(Scene())),
                         "Wheelset/Traction coefficient = 0, saved with 0.25",
                         "a run is not gone on with another drive"));
    BOOST_TEST(same_text(answer(parameters), "no message", "a state of the same entries is read"));
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
      "at most that, or start anew with Mesh/Prepared distance = 40 mm or Mesh/Window = moving");
    check_state(
      answer(parameters, 0.04, MeshWindow::moving),
      "Run/Rolling distance = 40 mm: on the rail of the saved state the wheel can roll 30 mm; give at "
      "most that, or start anew with it or with a longer Track/Rail length");
    check_state(
      answer(parameters, 0.04, MeshWindow::moving, "wing.slcs"),
      "Run/Rolling distance = 40 mm: the mesh of the saved state was made for 30 mm of rolling; give "
      "at most that, or start anew with it");
    check_state(answer(parameters, 0.01),
                "Run/Rolling distance = 10 mm: the saved state has rolled 10 mm; give more than that, and at "
                "most 30 mm");
  }

  void
  test_stops()
  {
    const auto stop = [](const Stop &why) {
      MPI_Barrier(MPI_COMM_WORLD);
      if (rank() == 0)
        write_stop(why, "runs/saved");
      MPI_Barrier(MPI_COMM_WORLD);
    };
    stop({"interrupted", 0.01, "", 0});
    BOOST_TEST(same_text(answer(parameters), "no message", "an interrupted run goes on"));
    stop({"the patch reaches the edge of the fine cells at 20.040 mm rolled",
          0.02004,
          "raise Mesh/Fine margin above 3 mm",
          0});
    check_state(
      answer(parameters),
      "the run stopped since the patch reaches the edge of the fine cells at 20.040 mm rolled, and "
      "would stop there again: raise Mesh/Fine margin above 3 mm, and start anew with --overwrite; or "
      "end the run before that place with --set \"Run/Rolling distance = 20 mm\"");
    BOOST_TEST(same_text(answer(parameters, 0.02), "no message", "before that place it can end"));
    BOOST_TEST(same_text(
      message_of([]() { protect_saved_states("runs/saved"); }),
      "Output/Folder = runs/saved: the folder holds a run that has not finished, saved at 10.000 mm "
      "rolled (it stopped since the patch reaches the edge of the fine cells at 20.040 mm rolled). Give "
      "--overwrite to start anew, or choose another Output/Folder.",
      "a new start over a run that stopped"));
    stop({"the energy balance is off", 0.01, "take a smaller Run/Time step factor", 0.06234});
    check_state(
      answer(parameters),
      "the run stopped since the energy balance is off, and would stop there again: take a smaller "
      "Run/Time step factor, and start anew with --overwrite; or let it pass with --set \"Run/Energy "
      "limit = 0.063\"");
    write_checkpoint(small_state(), "runs/saved", MPI_COMM_WORLD);
    BOOST_TEST(same_text(answer(parameters), "no message", "a run that has gone on since may go on again"));
    BOOST_TEST(same_text(
      message_of([]() { protect_saved_states("runs/saved"); }),
      "Output/Folder = runs/saved: the folder holds a run that has not finished, saved at 10.000 mm "
      "rolled. Give --resume to go on with it, --overwrite to start anew, or choose another "
      "Output/Folder.",
      "a new start over an interrupted run"));
    MPI_Barrier(MPI_COMM_WORLD);
  }

  /// A run that stopped before its first state.
  void
  test_nothing_saved()
  {
    write("runs/saved/parameters.prm", parameters);
    write("runs/saved/summary.json", "{\"finished\": false, \"stopped_because\": \"a value is not finite\"}");
    check_state(
      answer(parameters),
      "the run in this folder stopped before it had saved a state, since a value is not finite; start "
      "anew without --resume");
    BOOST_TEST(same_text(
      message_of([]() { protect_saved_states("runs/saved"); }), "no message", "which loses nothing"));
    MPI_Barrier(MPI_COMM_WORLD);
    if (rank() == 0)
      fs::remove("runs/saved/summary.json");
    BOOST_TEST(same_text(answer(parameters), "no message", "one that was killed before starts anew"));
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
    BOOST_TEST(same_text(notes,
                         damaged + "; the run goes on from the state before it, checkpoint_1.h5\n",
                         "the older of two states"));
  }

  void
  test_saved_states()
  {
    const std::string anew = "; start anew without --resume";
    check_state(answer(parameters), "there is no run to go on with; start without --resume");
    test_nothing_saved();
    write("runs/saved/summary.json", "{\"finished\": true}");
    check_state(answer(parameters), "the run in this folder has finished; there is nothing to go on with");
    write("runs/saved/summary.json", "{\"finished\": false}");
    write("runs/saved/checkpoint.json", "{\"format\": 1}");
    check_state(answer(parameters),
                "checkpoint.json is of format 1, this version of the program reads format 11" + anew);
    write("runs/saved/checkpoint.json", "no JSON");
    check_state(answer(parameters),
                "checkpoint.json is of format \"none\", this version of the program reads format 11" + anew);
    write("runs/saved/checkpoint.json", "{\"format\": 11}");
    check_state(answer(parameters), "checkpoint.json lists no saved state" + anew);

    write_checkpoint(small_state(), "runs/saved", MPI_COMM_WORLD);
    test_differences();
    test_stops();
    Checkpoint long_text = small_state();
    long_text.parameters = std::string(100000, '#') + "\n" + parameters;
    write_checkpoint(long_text, "runs/saved", MPI_COMM_WORLD);
    BOOST_TEST(same_text(answer(parameters), "no message", "a state with 100 000 characters of entries"));
    if (rank() == 0)
      remove_checkpoints("runs/saved");
    MPI_Barrier(MPI_COMM_WORLD);
    write_checkpoint(small_state(), "runs/saved", MPI_COMM_WORLD); // checkpoint_0.h5
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


BOOST_AUTO_TEST_CASE(messages_runs)
{
  const test::Parallel parallel;
  if (parallel.rank == 0)
    fs::remove_all("runs");
  MPI_Barrier(MPI_COMM_WORLD);
  test_folders();
  test_locks();
  test_saved_states();
  MPI_Barrier(MPI_COMM_WORLD);
  if (parallel.rank == 0)
    fs::remove_all("runs");
}
