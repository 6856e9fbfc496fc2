// label: long

// A jump over passages against the same passages computed: steel with one back stress of Armstrong and
// Frederick, whose flow goes on. What is extrapolated must be what is computed, as far as the jump itself
// says; and a rail that is extrapolated bears the wheel like any other.

#include <wheelrail/input/listing.h>
#include <wheelrail/output/summary.h>
#include <wheelrail/run/passage_jump.h>
#include <wheelrail/run/passage_table.h>

#include "parallel.h"
#include "small_scene.h"
#include "stopped_runs.h"

#include <cmath>
#include <filesystem>
#include <string>

using namespace wheelrail;
using namespace test;
namespace fs = std::filesystem;

namespace
{
  constexpr unsigned int passages = 12;

  Scene
  scene(const std::string &name)
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
    scene.passages                    = passages;
    scene.folder                      = "passage_jump_" + name;
    return scene;
  }

  double
  figure(const Scene &of, const unsigned int passage, const std::string &key)
  {
    return get_figure(read_summary(passage_folder(of.folder, passage) + "/summary.json"), key);
  }
} // namespace

int
main(int argc, char **argv)
{
  Parallel    parallel(argc, argv);
  const Scene all     = scene("computed");
  Scene       jumped  = scene("jumped");
  jumped.passage_jump = 5;
  for (const Scene &one : {all, jumped})
    {
      fs::remove_all(one.folder);
      check(run(one, false) == 0, "passages in " + one.folder);
    }
  const auto jumps = read_jumps(jumped.folder);
  if (!check(!jumps.empty(), "there is a jump"))
    return parallel.report();
  const PassageJump &jump = jumps.back();
  check(jump.judged && jump.kept, "it was judged, and kept");
  check(jump.error <= jumped.jump_error, "with an error of " + std::to_string(jump.error));
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
  for (const char *key : {"residual_lateral_stress_Pa", "residual_longitudinal_stress_Pa", "max_pressure_Pa"})
    check_near(
      figure(jumped, passages, key) / figure(all, passages, key), 1, 0.05, std::string(key) + ", likewise");
  return parallel.report();
}
