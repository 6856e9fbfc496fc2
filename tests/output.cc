// ranks: 1 2

// The output of a run: VTU files of all ranks, HDF5 tables, measures of a contact patch, summary,
// output folder. The files are read back with VTK and h5py by read_output.py.

#include <wheelrail/base/errors.h>
#include <wheelrail/base/read_file.h>
#include <wheelrail/output/figures.h>
#include <wheelrail/output/folder.h>
#include <wheelrail/output/hdf5_file.h>
#include <wheelrail/output/replace_file.h>
#include <wheelrail/output/root.h>
#include <wheelrail/output/summary.h>
#include <wheelrail/output/vtu.h>
#include <wheelrail/sampling/patch_measures.h>

#include "error_of.h"
#include "hertz_patch.h"
#include "parallel.h"
#include "read_output.h"

#include <deal.II/base/mpi.h>

#include <sys/resource.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <iostream>
#include <utility>
#include <vector>

using namespace wheelrail;
using namespace test;

namespace
{
  /// A row of `n_cells` cubes (or of their top faces) along Z from z0, with known fields.
  FieldMesh
  make_mesh(const unsigned int points_per_cell, const unsigned int n_cells, const double z0)
  {
    FieldMesh mesh;
    mesh.points_per_cell = points_per_cell;
    for (unsigned int k = 0; k <= n_cells; ++k)
      for (unsigned int j = 0; j < points_per_cell / 4; ++j)
        for (unsigned int i = 0; i < 2; ++i)
          mesh.points.push_back({{1e-3 * i, 1e-3 * j, z0 + 1e-3 * k}});
    const unsigned int layer = points_per_cell / 2;
    for (unsigned int k = 0; k < n_cells; ++k)
      for (unsigned int q = 0; q < points_per_cell; ++q)
        mesh.cells.push_back(k * layer + q);

    PointField stress{"pressure", "Pa", 1, {}}, motion{"displacement", "m", 3, {}};
    for (const auto &p : mesh.points)
      {
        stress.values.push_back(1e9 * p[2]);
        for (unsigned int d = 0; d < 3; ++d)
          motion.values.push_back((d + 1) * p[d]);
      }
    mesh.fields = {stress, motion};
    return mesh;
  }

  /// Whether `work` throws an error of type Error whose text contains all of `parts`.
  template <typename Error>
  void
  check_throws(const std::function<void()>    &work,
               const std::vector<std::string> &parts,
               const std::string              &text)
  {
    std::string message = "nothing was thrown";
    bool        good    = false;
    try
      {
        work();
      }
    catch (const Error &error)
      {
        message = error.what();
        good    = true;
        for (const std::string &part : parts)
          good = good && message.find(part) != std::string::npos;
      }
    BOOST_TEST(good, text + " [" + message + "]");
  }

  void
  test_vtu(const std::string &folder, const unsigned int rank)
  {
    // the first rank has 2 cells, each other 3; the last surface part is empty on two ranks
    write_vtu(make_mesh(8, 2 + (rank > 0), 0.01 * rank), folder, "volume", MPI_COMM_WORLD);
    write_vtu(make_mesh(4, rank == 0 ? 4 : 0, 0), folder, "surface", MPI_COMM_WORLD);

    FieldMesh wrong = make_mesh(8, 2, 0);
    if (rank == 0)
      wrong.fields[1].values.pop_back();
    check_throws<RunError>([&]() { write_vtu(wrong, folder, "wrong", MPI_COMM_WORLD); },
                           {"rank 0", "displacement", "35 values for 12 points"},
                           "a field of the wrong length is refused on all ranks");
    check_throws<RunError>(
      [&]() { write_vtu(make_mesh(8, 1, 0), folder + "/missing", "volume", MPI_COMM_WORLD); },
      {"missing/volume.vtu", "No such file or directory"},
      "a missing folder is named on all ranks");
  }

  void
  test_series(const std::string &folder)
  {
    PvdSeries series(folder + "/volume.pvd");
    series.add(0, "volume.vtu");
    series.add(0.002571234567, "volume.vtu");
    series.add(0.004, "gone.vtu");

    PvdSeries resumed(folder + "/volume.pvd");
    resumed.load();
    BOOST_TEST((resumed.entries().size() == 3 && resumed.entries()[2].second == "gone.vtu"),
               "a series is read back with its names");
    BOOST_TEST(near(resumed.entries()[1].first, 0.002571234567, 1e-12, "time of the second entry [s]"));
    resumed.add(0.004, "volume.vtu");
    BOOST_TEST(resumed.entries().size() == 3, "a time that comes again replaces the entry");
  }

  void
  test_hdf5(const std::string &folder)
  {
    History history{{"time", "normal_force"}, {"s", "N"}, {{0, 1e-3, 2e-3}, {100e3, 101e3, 102e3}}};
    write_history(history, folder + "/history.h5");
    const History back = read_history(folder + "/history.h5");
    BOOST_TEST(
      (back.names == history.names && back.units == history.units && back.columns == history.columns),
      "a history is read back as it was written");
    history.columns[1].pop_back();
    history.units.pop_back();
    check_throws<RunError>([&]() { write_history(history, folder + "/history.h5"); },
                           {"history.h5", "2 names, 1 units"},
                           "a history with a unit too few is refused");

    const PatchFields patch = hertz_patch(7.162e-3, 5.387e-3, 1e-3, 0.3, 0.4);
    {
      TickFile file(folder + "/patch.h5", false, 0);
      for (unsigned int tick = 0; tick < 3; ++tick)
        append_patch(file, patch);
    }
    TickFile resumed(folder + "/patch.h5", true, 2);
    BOOST_TEST(resumed.n_ticks() == 2, "a resumed patch file keeps the ticks asked for");
    PatchFields later = patch;
    later.time        = 0.25;
    append_patch(resumed, later);
    const PatchFields read = read_patch(folder + "/patch.h5", 2);
    BOOST_TEST((read.n_along == patch.n_along && read.n_lateral == patch.n_lateral && read.time == 0.25 &&
                read.pressure == patch.pressure && read.gap == patch.gap && read.state == patch.state),
               "a patch is read back as it was written");

    replace_file(folder + "/no.h5", std::string("no HDF5 at all"));
    check_throws<RunError>([&]() { TickFile(folder + "/no.h5", true, 1); },
                           {"no.h5", "no complete HDF5 file"},
                           "a file of another kind is named");
  }

  /// Files cannot grow beyond 10000 bytes: as good as a full disk, and it works for every user.
  void
  test_full_disk(const std::string &folder)
  {
    const std::string before = read_whole_file(folder + "/patch.h5");
    const auto        patch  = hertz_patch(7.162e-3, 5.387e-3, 1e-3, 0, 0);
    struct rlimit     old;
    getrlimit(RLIMIT_FSIZE, &old);
    struct rlimit small = old;
    small.rlim_cur      = 10000;
    std::signal(SIGXFSZ, SIG_IGN);
    setrlimit(RLIMIT_FSIZE, &small);
    const std::string message = test::error_of<RunError>([&]() {
      TickFile file(folder + "/patch.h5", true, 3);
      append_patch(file, patch);
    });
    setrlimit(RLIMIT_FSIZE, &old);
    BOOST_TEST((message.find("patch.h5\" cannot be written: File too large") != std::string::npos),
               "a file that cannot grow is named with the reason [" + message + "]");
    BOOST_TEST((read_whole_file(folder + "/patch.h5") == before), "the file written before is untouched");
    BOOST_TEST(!std::filesystem::exists(folder + "/patch.h5.part"), "no temporary file stays behind");
  }

  /// Largest errors over 30 positions of the grid against each ellipse.
  void
  test_hertz_extent(const std::vector<std::pair<double, double>> &ellipses,
                    const double                                  tolerance,
                    const std::string                            &text)
  {
    double area = 0, length = 0, width = 0;
    int    n = 0;
    for (const auto &[a, b] : ellipses)
      for (int sample = 0; sample < 30; ++sample, ++n)
        {
          // a Kronecker sequence: offsets spread evenly over the cell, the same on all machines
          const double u = std::fmod(0.5 + 0.754877666 * n, 1.), v = std::fmod(0.5 + 0.569840291 * n, 1.);
          const auto   m = measure_patch(hertz_patch(a, b, 1e-3, u, v));
          area           = std::max(area, std::abs(m.area / (M_PI * a * b) - 1));
          length         = std::max(length, std::abs(m.length / (2 * a) - 1));
          width          = std::max(width, std::abs(m.width / (2 * b) - 1));
        }
    BOOST_TEST(near(area, 0, tolerance, "largest relative error of the area, " + text));
    BOOST_TEST(near(length, 0, tolerance, "largest relative error of the length, " + text));
    BOOST_TEST(near(width, 0, tolerance, "largest relative error of the width, " + text));
  }

  void
  test_measures()
  {
    const double a = 7.162e-3, b = 5.387e-3, area = M_PI * a * b;

    // required: semi-axes of 5 to 10 mm; narrower patches have too few nodes for the same accuracy
    const std::vector<std::pair<double, double>> usual = {
      {5e-3, 5e-3}, {7.162e-3, 5.387e-3}, {5e-3, 10e-3}, {7.9e-3, 5.9e-3}, {10e-3, 5e-3}, {10e-3, 10e-3}};
    const std::vector<std::pair<double, double>> narrow = {{5e-3, 2.5e-3}, {2.5e-3, 5e-3}, {6.3e-3, 3.15e-3}};
    test_hertz_extent(usual, 0.01, "semi-axes 5 to 10 mm on 1 mm cells");
    test_hertz_extent(narrow, 0.02, "narrow, half width 2.5 to 3.15 mm on 1 mm cells");

    const auto m = measure_patch(hertz_patch(a, b, 1e-3, 0.25, 0.4));
    BOOST_TEST(near(m.area, area, 0.01 * area, "area of the ellipse [m2]"));
    BOOST_TEST(near(m.centre_along, 0, 2e-5, "centre along [m]"));
    BOOST_TEST(near(m.centre_of_pressure_lateral, 0, 2e-5, "centre of pressure, lateral [m]"));
    BOOST_TEST(near(
      m.normal_force, 2. / 3. * hertz_peak * area, 0.01 * 2. / 3. * hertz_peak * area, "normal force [N]"));
    BOOST_TEST(near(m.peak_pressure, hertz_peak, 0.006 * hertz_peak, "largest nodal pressure [Pa]"));
    BOOST_TEST(near(m.peak_pressure_fitted, hertz_peak, 0.005 * hertz_peak, "fitted peak [Pa]"));
    BOOST_TEST(near(
      m.traction_force_along, -0.3 * m.normal_force, 1e-6 * m.normal_force, "shear force on the rail [N]"));
    BOOST_TEST(near(m.max_traction, 0.3 * m.peak_pressure, 1, "largest shear traction [Pa]"));
    BOOST_TEST((m.n_patches == 1 && !m.touches_border), "one whole patch");
    BOOST_TEST((m.stick_fraction > 0.3 && m.stick_fraction < 0.7), "stick fraction of a half-sticking patch");

    const auto two = measure_patch(two_patches(hertz_patch(5e-3, 4e-3, 1e-3, 0.1, 0.2)));
    BOOST_TEST(two.n_patches == 2, "two separate patches are counted");
    BOOST_TEST(near(two.area, 2 * M_PI * 20e-6, 0.01 * 2 * M_PI * 20e-6, "area of two patches [m2]"));

    PatchFields empty = hertz_patch(a, b, 1e-3, 0, 0);
    std::fill(empty.pressure.begin(), empty.pressure.end(), 0.);
    const auto none = measure_patch(empty);
    BOOST_TEST((none.area == 0 && none.peak_pressure == 0 && none.n_loaded == 0 && none.width == 0),
               "a patch without load gives zeros");
    empty.gap.pop_back();
    check_throws<RunError>([&]() { measure_patch(empty); }, {"values where"}, "a short field is refused");
  }

  void
  test_summary(const std::string &folder)
  {
    Summary summary;
    summary.title        = "a title with \"quotes\"";
    summary.max_pressure = 1234.5e6;
    summary.contact_area = 176.6e-6;
    summary.elements     = 123456;
    set_figure(summary, "normal_force_N", 103000.5);
    set_figure(summary, "normal_force_std_N", 321);
    summary.finished = true;
    write_summary(summary, folder + "/summary.json");

    const Summary back = read_summary(folder + "/summary.json");
    BOOST_TEST(near(back.normal_force, 103000.5, 0, "normal force read back [N]"));
    BOOST_TEST(near(get_figure(back, "normal_force_std_N"), 321, 0, "a further figure read back [N]"));
    BOOST_TEST((std::isnan(back.creepage) && back.finished && back.title == summary.title),
               "a missing figure stays missing, text and state come back");
    for (const Figure &figure : all_figures())
      BOOST_TEST((figure_with_key(figure.key()) == &figure && &figure_named(figure.name) == &figure),
                 std::string(figure.name) + " stands once in the table of figures");
  }

  void
  test_folder(const std::string &folder)
  {
    const std::string run    = folder + "/deep/run";
    const auto        finish = [&](const bool finished) {
      Summary summary;
      summary.finished = finished;
      write_summary(summary, run + "/summary.json");
    };
    const auto begin = [&](const FolderMode mode, const std::string &input, const std::string &parameters) {
      OutputFolder(run, mode, input, MPI_COMM_WORLD).begin(parameters, mode == FolderMode::resume);
    };
    const auto open = [](const std::string &name) {
      OutputFolder(name, FolderMode::fresh, "d", MPI_COMM_WORLD);
    };
    begin(FolderMode::fresh, "set Title = a\n", "all = a\n");
    BOOST_TEST((read_whole_file(run + "/input.prm") == "set Title = a\n" &&
                read_whole_file(run + "/parameters.prm") == "all = a\n"),
               "a new folder holds input and parameters");
    MPI_Barrier(MPI_COMM_WORLD);

    on_root(MPI_COMM_WORLD, [&]() {
      finish(true);
      replace_file(run + "/old.vtu", std::string("old"));
      replace_file(run + "/intervals.csv", std::string("old"));
      replace_file(run + "/notes.txt", std::string("mine"));
    });
    check_throws<InputError>([&]() { begin(FolderMode::fresh, "b", "b"); },
                             {"deep/run", "holds a finished run", "--overwrite"},
                             "the folder of a finished run is refused on all ranks");
    BOOST_TEST(
      (std::filesystem::exists(run + "/old.vtu") && read_whole_file(run + "/parameters.prm") == "all = a\n"),
      "the refused folder is unchanged");
    MPI_Barrier(MPI_COMM_WORLD);

    begin(FolderMode::resume, "b", "b");
    BOOST_TEST(std::filesystem::exists(run + "/old.vtu"), "resuming keeps all files");
    MPI_Barrier(MPI_COMM_WORLD);
    begin(FolderMode::overwrite, "c", "c");
    BOOST_TEST((!std::filesystem::exists(run + "/old.vtu") &&
                !std::filesystem::exists(run + "/intervals.csv") &&
                !std::filesystem::exists(run + "/summary.json")),
               "overwriting removes the files of the earlier run");
    BOOST_TEST((read_whole_file(run + "/notes.txt") == "mine"), "overwriting leaves the user's files alone");

    {
      const OutputFolder held(run, FolderMode::overwrite, "e", MPI_COMM_WORLD);
      check_throws<InputError>([&]() { begin(FolderMode::overwrite, "f", "f"); },
                               {"deep/run", "another run works in this folder, process "},
                               "a folder in which a run works is refused on all ranks");
    }
    MPI_Barrier(MPI_COMM_WORLD); // the root removes it
    BOOST_TEST((!std::filesystem::exists(run + "/run.lock") && read_whole_file(run + "/input.prm") == "c"),
               "afterwards the lock is gone, and nothing was changed");
    check_throws<InputError>([&]() { open(run + "/notes.txt/sub"); },
                             {"notes.txt\" is a file"},
                             "a file in the place of a folder is named");
    check_throws<InputError>([&]() { open("/proc/wheelrail/run"); },
                             {"/proc/wheelrail/run", "cannot be made"},
                             "a place without rights is named");
    check_throws<InputError>([&]() { open(""); }, {"empty"}, "an empty name is refused");
  }

  void
  test_scripts(const std::string &folder, const unsigned int n_ranks)
  {
    const std::string python = "/usr/bin/python3 ", tests = WHEELRAIL_TEST_DIR;
    std::cout << std::flush;
    BOOST_TEST(
      (std::system((python + tests + "/read_output.py " + folder + " " + std::to_string(n_ranks)).c_str()) ==
       0),
      "read_output.py finds what belongs in the files");
    if (n_ranks == 1) // drawing takes seconds and does not depend on ranks
      BOOST_TEST(std::system((python + tests + "/read_report.py " + WHEELRAIL_SOURCE_DIR +
                              "/source/report/report.py " + folder)
                               .c_str()) == 0,
                 "read_report.py finds pictures and page of the report");
  }

  std::string
  make_temporary_folder()
  {
    std::string name = (std::filesystem::temp_directory_path() / "wheelrail_output_XXXXXX").string();
    on_root(MPI_COMM_WORLD, [&]() {
      if (mkdtemp(&name[0]) == nullptr)
        throw RunError("no temporary folder");
    });
    MPI_Bcast(&name[0], static_cast<int>(name.size()), MPI_CHAR, 0, MPI_COMM_WORLD);
    return name;
  }
} // namespace


BOOST_FIXTURE_TEST_CASE(output, test::Parallel)
{
  const unsigned int rank    = dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD);
  const unsigned int n_ranks = dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD);
  const std::string  folder  = make_temporary_folder();

  test_vtu(folder, rank);
  test_folder(folder);
  if (rank == 0)
    {
      test_series(folder);
      test_hdf5(folder);
      test_full_disk(folder);
      test_measures();
      test_summary(folder);
      test_scripts(folder, n_ranks);
    }
  MPI_Barrier(MPI_COMM_WORLD);
  on_root(MPI_COMM_WORLD, [&]() { std::filesystem::remove_all(folder); });
}
