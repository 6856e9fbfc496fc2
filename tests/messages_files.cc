// What the program answers to files of an output folder that are missing, damaged or not to be written, to
// pipes and devices in place of files, and to a start without contact, word by word.

#include "messages.h"
#include "parallel.h"
#include "small_scene.h"

#include <wheelrail/application/command_line.h>
#include <wheelrail/application/geometry_picture.h>
#include <wheelrail/application/material_command.h>
#include <wheelrail/base/log.h>
#include <wheelrail/base/read_file.h>
#include <wheelrail/input/input_file.h>
#include <wheelrail/input/motion_file.h>
#include <wheelrail/output/summary.h>
#include <wheelrail/output/tick_file.h>
#include <wheelrail/output/vtu.h>
#include <wheelrail/profiles/profile_file.h>
#include <wheelrail/run/run_start.h>
#include <wheelrail/statics/static_start.h>
#include <wheelrail/wheel/given_distance.h>

#include <deal.II/base/mpi.h>

#include <filesystem>
#include <fstream>
#include <functional>
#include <sstream>
#include <string>

using namespace wheelrail;
using test::message_of;
using test::same_text;

namespace
{
  namespace fs = std::filesystem;

  void
  check_message(const std::function<void()> &work, const std::string &expected)
  {
    BOOST_TEST(same_text(message_of(work), expected, expected));
  }

  BOOST_FIXTURE_TEST_CASE(test_damaged_files, test::Parallel)
  {
    check_message([]() { read_whole_file("nowhere.json"); },
                  "The file \"nowhere.json\" cannot be read: No such file or directory.");
    std::ofstream("damaged") << "{\"finished\": tr";
    check_message([]() { read_summary("damaged"); },
                  "The file \"damaged\" is no summary of a run; compute it again with \"./wheelrail run\".");
    check_message([]() { TickFile("damaged", true, 3); },
                  "The HDF5 file \"damaged\": HDF5 cannot read it: it is no complete HDF5 file; start anew "
                  "without --resume.");
    check_message(
      []() { PvdSeries("damaged").load(); },
      "The series file \"damaged\" is not a readable .pvd file: <unspecified file>(1): expected <. "
      "Delete it, or start without --resume.");
    std::ofstream("damaged") << "<VTKFile></VTKFile>";
    check_message([]() { PvdSeries("damaged").load(); },
                  "The series file \"damaged\" is not a readable .pvd file: No such node "
                  "(VTKFile.Collection). Delete it, or start without --resume.");
    fs::remove("damaged");
  }

  BOOST_FIXTURE_TEST_CASE(test_places, test::Parallel)
  {
    check_message([]() { Log("nowhere/log.txt"); },
                  "nowhere/log.txt: the log file cannot be written: No such file or directory");
    check_message(
      []() {
        std::ostringstream out;
        draw_profiles(Scene(), make_geometry(Scene()), "nowhere/profiles", out);
      },
      "nowhere/profiles.csv: cannot be written; choose a folder with room and permission to write");
    // without the plotting package
    fs::create_directory("no_packages");
    std::ofstream("no_packages/matplotlib.py") << "raise ImportError('left out by the test')\n";
    setenv("PYTHONPATH", "no_packages", 1);
    check_message(
      []() {
        std::ostringstream out;
        draw_profiles(Scene(), make_geometry(Scene()), "profiles", out);
      },
      "profiles.png could not be drawn from profiles.csv; install the Debian package python3-matplotlib");
    unsetenv("PYTHONPATH");
    fs::remove_all("no_packages");
  }

  BOOST_FIXTURE_TEST_CASE(test_early_stop, test::Parallel)
  {
    fs::create_directories("stopped");
    Summary summary;
    summary.stop_reason = "a value is not finite";
    write_summary(summary, "stopped/summary.json");
    std::ofstream("stopped/parameters.prm") << "set Title = x\n";
    check_message(
      []() {
        std::ostringstream out;
        execute({"compare", "stopped"}, {}, out);
      },
      "The file \"stopped/summary.json\" lacks one of vertical_force_N, longitudinal_force_N and "
      "max_pressure_Pa: the run did not "
      "get so far that its patch could be compared.");
    fs::remove_all("stopped");
  }

  // The wheel hangs above the rail: Newton's method finds no contact to begin with.
  BOOST_FIXTURE_TEST_CASE(test_start_without_contact, test::Parallel)
  {
    const Scene scene    = test::small_scene(8e-3);
    Model       model    = make_model(scene, make_geometry(scene), MPI_COMM_WORLD);
    StaticLoads loads    = static_loads(scene, model);
    loads.first_approach = -1e-4;
    check_message(
      [&]() {
        static_start(
          *model.discretization, model.solid, *model.contact, model.parts, loads, [](const std::string &) {});
      },
      "the static start lost the contact between wheel and rail; lower Contact/Penalty scale or "
      "Mesh/Solution "
      "cell size");
  }

  void
  test_other_than_file(const std::string &path, const std::string &kind)
  {
    const std::string begin = path + ": " + kind + "; ";
    check_message([&]() { read_input_file(path); }, begin + "a parameter file (.prm) is needed");
    check_message([&]() { read_motion_file(path); },
                  begin + "a motion is a table of rows over time or distance");
    check_message([&]() { read_curve_file(path, MotionQuantity::creepage); },
                  begin + "--beside needs a table of points to draw beside the curve");
    check_message([&]() { read_distance_file(path); }, begin + "rows x, y, distance in mm are needed");
    MaterialTest test;
    test.file = path;
    check_message([&]() { material_path(test); }, begin + "rows of strains and stresses are needed");
    check_message([&]() { read_profile_file(path, {}); },
                  path + ": not a file; a profile file (.prr, .prw, .ban, .whl or two columns) is needed");
    check_message([&]() { read_whole_file(path); },
                  "The file \"" + path + "\" is no ordinary file, but " + kind + ".");
    check_message([&]() { scene_from_text("include " + path + "\n", "x.prm", {}); },
                  "x.prm:1: include " + path + ": " + begin + "a parameter file (.prm) is needed");
  }

  /// Only ordinary files are read: nobody may ever write into a pipe, and a device may have no end.
  BOOST_FIXTURE_TEST_CASE(test_other_than_files, test::Parallel)
  {
    const std::string pipe = "a_pipe";
    fs::remove(pipe);
    if (::mkfifo(pipe.c_str(), 0666) != 0)
      std::abort();
    test_other_than_file(pipe, "a pipe");
    test_other_than_file("/dev/zero", "a device");
    test_other_than_file("/", "a folder");
    fs::remove(pipe);
  }
} // namespace
