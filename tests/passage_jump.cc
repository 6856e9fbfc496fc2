// label: long

// A jump over passages against the same passages computed: steel with one back stress of Armstrong and
// Frederick, whose flow goes on. What is extrapolated must be what is computed, as far as the jump itself
// says; and a rail that is extrapolated bears the wheel like any other. The same over rounds of two wheels.

#include <wheelrail/input/listing.h>
#include <wheelrail/output/summary.h>
#include <wheelrail/run/passage_jump.h>
#include <wheelrail/run/passage_table.h>

#include "parallel.h"
#include "small_scene.h"
#include "stopped_runs.h"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>

using namespace wheelrail;
using namespace test;
namespace fs = std::filesystem;

namespace
{
  Scene
  scene(const std::string &name, const unsigned int rounds)
  {
    Scene scene                       = small_scene(4e-3);
    scene.rolling_distance            = 28e-3;
    scene.averaging_distance          = 8e-3;
    scene.rail_length                 = 0.4;
    scene.ticks                       = 1;
    scene.volume_fields               = false;
    scene.checkpoint_interval         = 1e4;
    scene.rail_material.law           = SteelLaw::chaboche;
    scene.rail_material.yield_stress  = 300e6;
    scene.rail_material.cyclic.moduli = {60e9};
    scene.rail_material.cyclic.rates  = {300};
    scene.passages                    = rounds;
    scene.folder                      = "passage_jump_" + name;
    return scene;
  }

  double
  figure(const Scene &of, const unsigned int passage, const std::string &key)
  {
    return get_figure(read_summary(passage_folder(of.folder, passage) + "/summary.json"), key);
  }

  /// Holds a family of `passages` with jumps against `all` of them computed, `of_round` wheels a round.
  void
  compare(const Scene &all, const Scene &jumped, const unsigned int of_round)
  {
    for (const Scene &one : {all, jumped})
      {
        fs::remove_all(one.folder);
        check(run(one, false) == 0, "passages in " + one.folder);
      }
    const unsigned int passages = all.passages * of_round;
    const auto         jumps    = read_jumps(jumped.folder);
    if (!check(!jumps.empty(), "there is a jump"))
      return;
    const PassageJump &jump = jumps.back();
    check(jump.judged && jump.kept, "it was judged, and kept");
    check(jump.error <= jumped.jump_error, "with an error of " + std::to_string(jump.error));
    check(jump.from % of_round == 0 && jump.to % of_round == 0, "it goes over whole rounds");
    check(!fs::exists(passage_folder(jumped.folder, jump.to) + "/summary.json"),
          "that passage is not computed");
    check_near(
      figure(jumped, jump.to + 1, "first_force_over_load"), 1, 0.02, "the extrapolated rail bears the wheel");
    const double strain = figure(all, passages, "rail_plastic_strain"),
                 grown  = strain - figure(all, jump.from, "rail_plastic_strain");
    check(grown > 0.3 * strain, "the strain has grown on since: " + std::to_string(grown / strain));
    check_near(figure(jumped, passages, "rail_plastic_strain") / strain,
               1,
               0.05,
               "plastic strain, jumped over computed");
    for (const char *key :
         {"residual_lateral_stress_Pa", "residual_longitudinal_stress_Pa", "max_pressure_Pa"})
      check_near(
        figure(jumped, passages, key) / figure(all, passages, key), 1, 0.05, std::string(key) + ", likewise");
  }
} // namespace

int
main(int argc, char **argv)
{
  Parallel parallel(argc, argv);
  Scene    jumped     = scene("jumped", 12);
  jumped.passage_jump = 5;
  compare(scene("computed", 12), jumped, 1);

  if (parallel.rank == 0)
    std::ofstream("two_wheels.csv") << "load [kN], traction\n105, 0.25\n90, 0.1\n";
  MPI_Barrier(MPI_COMM_WORLD);
  Scene rounds             = scene("rounds", 10);
  rounds.passage_list      = "two_wheels.csv";
  Scene over_rounds        = rounds;
  over_rounds.folder       = "passage_jump_over_rounds";
  over_rounds.passage_jump = 2;
  compare(rounds, over_rounds, 2);
  return parallel.report();
}
