// ranks: 1 2
// needs: wear

// Processes share the rows of a mix: the same bits as one alone, and one sentence from all where a row fails.

#include "messages.h"
#include "parallel.h"
#include "worn_profiles.h"

#include <wheelrail/application/command_line.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

using namespace wheelrail;
using test::near;

namespace
{
  /// A table as the mix of a scene; written by each process under a name of its own.
  Scene
  mixed(const std::string &name, const std::string &table)
  {
    Scene             scene = test::wearing_scene(0.1, 50e6);
    const std::string path =
      name + std::to_string(dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD)) + ".csv";
    std::ofstream(path) << table;
    scene.wear_plan.mix = path;
    return scene;
  }

  BOOST_FIXTURE_TEST_CASE(test_same_bits, test::Parallel)
  {
    const Scene scene = mixed("three", "lateral shift [mm],traction,weight\n-2,0.1,2\n0,0,3\n2,-0.1,1\n");
    const SceneProfiles profiles = read_profiles(scene);
    const WornShape     rail = rail_shape(profiles.rail), wheel = wheel_shape(profiles.wheel);
    double              weights = 1;
    const auto          rows    = mix_rows(scene, scene.wheel_load, weights);
    const MixWear       alone   = wear_of_mix(rows, profiles, rail, wheel),
                  shared        = wear_of_mix(rows, profiles, rail, wheel, team_of_job());
    BOOST_TEST((alone.rail_section == shared.rail_section && alone.wheel_section == shared.wheel_section),
               "worn sections, bit by bit");
    BOOST_TEST((alone.rail_damage == shared.rail_damage && alone.wheel_cracks == shared.wheel_cracks),
               "damage and cracks, bit by bit");
    BOOST_TEST(near(shared.mean_t_gamma / alone.mean_t_gamma, 1, 0, "T-gamma"));
    BOOST_TEST(near(shared.axle_load / 200e3, 1, 1e-12, "axle load"));
    double section = 0;
    for (const double of_point : shared.rail_section)
      section += of_point;
    BOOST_TEST(section > 0, "something wears");
  }

  BOOST_FIXTURE_TEST_CASE(test_fault, test::Parallel)
  {
    const Scene         scene    = mixed("far", "lateral shift [mm],yaw [mrad]\n0,0\n-11.9,50\n1,0\n");
    const SceneProfiles profiles = read_profiles(scene);
    const WornShape     rail = rail_shape(profiles.rail), wheel = wheel_shape(profiles.wheel);
    double              weights = 1;
    const auto          rows    = mix_rows(scene, scene.wheel_load, weights);
    const std::string   said =
      test::message_of([&]() { wear_of_mix(rows, profiles, rail, wheel, team_of_job()); });
    BOOST_TEST((said.find(".csv, row 2: Wheel 'S1002' and rail '54E1'") != std::string::npos),
               "a row that does not touch, on each process: " + said);
  }

  /// Lines of the table of a folder.
  std::vector<std::string>
  rows_of(const std::string &folder)
  {
    std::ifstream            file(folder + "-wear/wear.csv");
    std::vector<std::string> rows;
    for (std::string row; std::getline(file, row);)
      rows.push_back(row);
    return rows;
  }

  /// The command: the first process alone speaks and writes; a longer plan goes on.
  BOOST_FIXTURE_TEST_CASE(test_command, test::Parallel)
  {
    const unsigned int rank  = dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD),
                       size  = dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD);
    const std::string folder = "worn_by_" + std::to_string(size);
    if (rank == 0)
      for (const char *const end : {"-wear", "_at_once-wear"})
        std::filesystem::remove_all(folder + end);
    MPI_Barrier(MPI_COMM_WORLD);
    std::ostringstream out;
    const auto         wear = [&](const std::string &load, const std::string &folder) {
      out.str("");
      return execute({"wear",
                      std::string(WHEELRAIL_SOURCE_DIR) + "/prm/wear.prm",
                      "--no-pictures",
                      "--set",
                      "Wear/Gross load = " + load,
                      "--set",
                      "Half-space/Element size = 1 mm",
                      "--set",
                      "Output/Folder = " + folder},
                     {},
                     out);
    };
    BOOST_TEST(wear("0.2 Mt", folder) == 0, "the command ends");
    BOOST_TEST((out.str().empty() == (rank != 0)), "the first process alone speaks");
    BOOST_TEST(std::filesystem::exists(folder + "-wear/wear.csv"), "and writes");
    MPI_Barrier(MPI_COMM_WORLD);
    BOOST_TEST(test::same_text(
      test::message_of([&]() { wear("0.1 Mt", folder); }),
      folder +
        "-wear: holds states of another scene, up to 0.2 Mt: Wear/Gross load = 0.1 Mt, saved with "
        "0.2 Mt; set it back to continue with them, choose another Output/Folder, or give --overwrite to "
        "start anew",
      "a shorter plan"));
    const std::vector<std::string> before = rows_of(folder);
    MPI_Barrier(MPI_COMM_WORLD);
    BOOST_TEST(wear("0.3 Mt", folder) == 0, "a longer plan goes on");
    BOOST_TEST(((rank == 0) == (out.str().find("resuming from step ") != std::string::npos)), "and says so");
    BOOST_TEST(wear("0.3 Mt", folder + "_at_once") == 0, "one at once");
    MPI_Barrier(MPI_COMM_WORLD);
    const std::vector<std::string> after = rows_of(folder), at_once = rows_of(folder + "_at_once");
    BOOST_TEST(
      (after.size() > before.size() &&
       std::equal(before.begin(), before.end() - 1, after.begin())), // the last one had no step from it
      "states up to the old end are kept");
    BOOST_TEST((at_once.front() == after.front()), "the same columns");
    const auto section = [](const std::string &row) {
      std::istringstream values(row);
      std::string        value;
      for (int column = 0; column <= 6; ++column)
        std::getline(values, value, ',');
      return std::stod(value);
    };
    BOOST_TEST((at_once.front().find("rail_depth_m,wheel_depth_m,rail_section_m2") != std::string::npos),
               "columns: " + at_once.front());
    BOOST_TEST(near(section(after.back()) / section(at_once.back()), 1, 0.01, "worn section of both"));
    BOOST_TEST(!std::filesystem::exists(folder + "-wear/run.lock"), "no lock is left");
  }
} // namespace
