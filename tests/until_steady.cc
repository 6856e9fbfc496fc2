// ranks: 2

// A run that ends by itself when it is steady: it ends before its longest distance, with a tick and means
// there, and with the same bits when it is interrupted on the way; one that spins up rolls to the end and
// says so.

#include <wheelrail/output/summary.h>

#include "parallel.h"
#include "read_output.h"
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
  Scene
  scene(const std::string &name)
  {
    Scene scene               = small_scene(4e-3);
    scene.title               = "until steady";
    scene.rail_length         = 0.4;
    scene.rolling_distance    = 0; // until steady
    scene.longest_distance    = 80e-3;
    scene.standard_error      = 0.05; // cells of 4 mm
    scene.averaging_distance  = 8e-3;
    scene.ticks               = 4;
    scene.checkpoint_interval = 1e4;
    scene.folder              = "until_steady_" + name;
    return scene;
  }
} // namespace


BOOST_AUTO_TEST_CASE(until_steady)
{
  const Parallel parallel;
  const Scene    whole = scene("whole"), broken = scene("broken");
  BOOST_TEST(run(whole, false, 120) == 3, "interrupted soon after the start");
  if (parallel.rank == 0)
    {
      fs::remove_all(broken.folder);
      fs::copy(whole.folder, broken.folder);
    }
  MPI_Barrier(MPI_COMM_WORLD);
  BOOST_TEST(run(whole, true) == 0, "gone on to the end in one go");
  const Summary end = read_summary(whole.folder + "/summary.json");
  BOOST_TEST((end.ended == "steady" && end.finished), "it is steady: " + end.ended_because);
  BOOST_TEST(end.rolled_distance < 0.95 * whole.longest_distance, "before its longest distance");
  const double from = get_figure(end, "means_from_m"), length = end.rolled_distance - from;
  BOOST_TEST(from >= end.patch_longitudinal, "means begin one patch length past the start");
  BOOST_TEST(near(length / 4e-3, std::round(length / 4e-3), 0.02, "over whole cells"));
  BOOST_TEST((get_figure(end, "normal_force_error_N") > 0 &&
              get_figure(end, "normal_force_error_N") < 0.05 * 0.5 * end.normal_force),
             "with a standard error below the one asked for");

  const auto half = static_cast<unsigned long>(0.5 * end.time_steps);
  BOOST_TEST(run(broken, true, half) == 3, "the other is interrupted half way");
  BOOST_TEST(run(broken, true) == 0, "and goes on to the end");
  const Summary other = read_summary(broken.folder + "/summary.json");
  const History a     = read_history(whole.folder + "/history.h5"),
                b     = read_history(broken.folder + "/history.h5");
  BOOST_TEST((a.columns[0].size() > 50 && a.columns == b.columns), "the same history");
  BOOST_TEST((other.ended == "steady" && other.time_steps == end.time_steps), "it ends at the same step");
  for (const char *key : {"normal_force_N", "creepage", "creepage_error", "means_from_m"})
    BOOST_TEST((get_figure(other, key) == get_figure(end, key)), std::string("the same ") + key);

  Scene spins                = scene("spins");
  spins.traction_coefficient = 0.6; // of friction 0.5
  spins.longest_distance     = 45e-3;
  BOOST_TEST(run(spins, false) == 0, "a wheel that spins up");
  const Summary spun = read_summary(spins.folder + "/summary.json");
  BOOST_TEST((spun.ended == "not steady" && spun.finished), "is not steady: " + spun.ended_because);
  BOOST_TEST(near(spun.rolled_distance, 45e-3, 1e-9, "and rolls to the end"));
}
