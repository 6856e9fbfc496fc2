// Run/Error estimate = two meshes: cells of 4 mm, then of 2 mm; results that true bodies do not know have
// intervals; the first is not computed again when the second was interrupted.

#include <wheelrail/base/read_file.h>
#include <wheelrail/output/summary.h>

#include "parallel.h"
#include "small_scene.h"
#include "stopped_runs.h"

#include <filesystem>
#include <string>

using namespace wheelrail;
using namespace test;
namespace fs = std::filesystem;


BOOST_AUTO_TEST_CASE(two_meshes)
{
  const Parallel parallel;
  Scene          scene       = small_scene(2e-3);
  scene.error_estimate       = ErrorEstimate::two_meshes;
  scene.traction_coefficient = scene.friction.at_rest = 0; // which starts faster
  scene.rolling_distance                              = 2e-3;
  scene.averaging_distance                            = 2e-3;
  scene.ticks                                         = 2;
  scene.volume_fields                                 = false;
  scene.folder                                        = "two_meshes";
  const std::string first                             = scene.folder + "-coarse";
  BOOST_TEST(run(scene, false, 40) == 3, "interrupted on cells of 4 mm");
  BOOST_TEST(!fs::exists(scene.folder + "/summary.json"), "before those of 2 mm");
  BOOST_TEST(run(scene, true, 10000) == 0, "gone on to the end of both");
  const auto    ended   = fs::last_write_time(first + "/summary.json");
  const Summary coarser = read_summary(first + "/summary.json"),
                fine    = read_summary(scene.folder + "/summary.json");
  const double change   = fine.max_von_mises - coarser.max_von_mises;
  BOOST_TEST((coarser.finished && change != 0), "other cells");
  BOOST_TEST((get_figure(fine, "max_von_mises_low_Pa") <= fine.max_von_mises + change &&
              get_figure(fine, "max_von_mises_high_Pa") >= fine.max_von_mises + change),
             "the end of the first order lies in the interval");
  const std::string causes = read_whole_file(scene.folder + "/intervals.csv");
  BOOST_TEST((causes.find("max_von_mises,Pa,two meshes,") != std::string::npos), "its cause");
  BOOST_TEST((causes.find("max_pressure,Pa,two meshes,") == std::string::npos),
             "the true bodies know the peak better");
  BOOST_TEST((fine.note.find(
                "Intervals: by the run on cells of 4 mm, where the true bodies do not know the result.") !=
              std::string::npos),
             fine.note);
  if (parallel.rank == 0)
    fs::remove(scene.folder + "/summary.json");
  MPI_Barrier(MPI_COMM_WORLD);
  BOOST_TEST(run(scene, true, 40) == 3, "the second is begun anew and interrupted");
  BOOST_TEST((fs::last_write_time(first + "/summary.json") == ended), "the first is kept");
}
