// ranks: 1 2

// Processes share the rows of a mix: the same bits as one alone, and one sentence from all where a row fails.

#include "messages.h"
#include "worn_profiles.h"

#include <wheelrail/application/command_line.h>
#include <wheelrail/base/errors.h>

#include <deal.II/base/mpi.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

using namespace wheelrail;
using test::check;
using test::check_near;

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

  void
  test_same_bits()
  {
    const Scene scene = mixed("three", "lateral shift [mm],traction,weight\n-2,0.1,2\n0,0,3\n2,-0.1,1\n");
    const SceneProfiles profiles = read_profiles(scene);
    const WornShape     rail = rail_shape(profiles.rail), wheel = wheel_shape(profiles.wheel);
    double              weights = 1;
    const auto          rows    = mix_rows(scene, scene.wheel_load, weights);
    const MixWear       alone   = wear_of_mix(rows, profiles, rail, wheel),
                  shared        = wear_of_mix(rows, profiles, rail, wheel, team_of_job());
    check(alone.rail_section == shared.rail_section && alone.wheel_section == shared.wheel_section,
          "worn sections, bit by bit");
    check(alone.rail_damage == shared.rail_damage && alone.wheel_cracks == shared.wheel_cracks,
          "damage and cracks, bit by bit");
    check_near(shared.mean_t_gamma / alone.mean_t_gamma, 1, 0, "T-gamma");
    check_near(shared.axle_load / 200e3, 1, 1e-12, "axle load");
    double section = 0;
    for (const double of_point : shared.rail_section)
      section += of_point;
    check(section > 0, "something wears");
  }

  void
  test_fault()
  {
    const Scene         scene    = mixed("far", "lateral shift [mm],yaw [mrad]\n0,0\n-11.9,50\n1,0\n");
    const SceneProfiles profiles = read_profiles(scene);
    const WornShape     rail = rail_shape(profiles.rail), wheel = wheel_shape(profiles.wheel);
    double              weights = 1;
    const auto          rows    = mix_rows(scene, scene.wheel_load, weights);
    const std::string   said =
      test::message_of([&]() { wear_of_mix(rows, profiles, rail, wheel, team_of_job()); });
    check(said.find(".csv, row 2: Wheel 'S1002' and rail '54E1'") != std::string::npos,
          "a row that does not touch, on each process: " + said);
  }

  /// The command: the first process alone speaks and writes.
  void
  test_command()
  {
    const unsigned int rank  = dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD),
                       size  = dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD);
    const std::string folder = "worn_by_" + std::to_string(size);
    if (rank == 0)
      std::filesystem::remove_all(folder + "-wear");
    MPI_Barrier(MPI_COMM_WORLD);
    std::ostringstream out;
    const auto         wear = [&](const std::string &load) {
      return execute({"wear",
                      WHEELRAIL_SOURCE_DIR "/prm/wear.prm",
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
    check(wear("0.2 Mt") == 0, "the command ends");
    check(out.str().empty() == (rank != 0), "the first process alone speaks");
    check(std::filesystem::exists(folder + "-wear/wear.csv"), "and writes");
    MPI_Barrier(MPI_COMM_WORLD);
    test::check_text(
      test::message_of([&]() { wear("0.1 Mt"); }),
      folder +
        "-wear: holds states of another scene, up to 0.2 Mt: Wear/Gross load = 0.1 Mt, saved with "
        "0.2 Mt; set it back to go on with them, choose another Output/Folder, or give --overwrite to "
        "start anew",
      "a shorter plan");
    MPI_Barrier(MPI_COMM_WORLD);
    check(!std::filesystem::exists(folder + "-wear/run.lock"), "no lock is left");
  }
} // namespace


int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  test_same_bits();
  test_fault();
  test_command();
  return test::report();
}
