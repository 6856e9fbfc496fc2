// ranks: 1
// long ranks: 2

// Runs with a moving window that are interrupted before and after a change of the mesh and go on: the same
// bits.

#include <wheelrail/output/summary.h>
#include <wheelrail/output/vtu.h>

#include "parallel.h"
#include "read_output.h"
#include "small_scene.h"
#include "stopped_runs.h"

#include <filesystem>
#include <string>

using namespace wheelrail;
using namespace test;
namespace fs = std::filesystem;

namespace
{
  Scene
  scene(const std::string &name, const int size)
  {
    Scene scene               = small_scene(4e-3);
    scene.title               = "stopped around a change of the mesh";
    scene.window              = MeshWindow::moving;
    scene.rolling_distance    = 18e-3;
    scene.evaluate_at         = 9e-3;
    scene.rail_length         = 0.4;
    scene.ticks               = 5;
    scene.checkpoint_interval = 1e4;
    scene.folder              = "checkpoint_window_" + std::to_string(size) + "_" + name;
    return scene;
  }
} // namespace


BOOST_AUTO_TEST_CASE(checkpoint_window)
{
  const Parallel parallel;
  const Scene    base = scene("base", parallel.size), one_go = scene("one_go", parallel.size);
  BOOST_TEST(run(base, false, 50) == 3, "interrupted soon after the static start");
  if (parallel.rank == 0)
    {
      fs::remove_all(one_go.folder);
      fs::copy(base.folder, one_go.folder);
    }
  MPI_Barrier(MPI_COMM_WORLD);
  BOOST_TEST(run(one_go, true) == 0, "gone on to the end in one go");
  const Summary       whole  = read_summary(one_go.folder + "/summary.json");
  const double        steps  = whole.time_steps;
  const unsigned long before = static_cast<unsigned long>(0.85 * steps),
                      after  = static_cast<unsigned long>(0.92 * steps);
  BOOST_TEST(run(base, true, before) == 3, "interrupted before the change of the mesh, at 16 mm");
  BOOST_TEST(run(base, true, after) == 3, "interrupted after it");
  BOOST_TEST(run(base, true) == 0, "gone on to the end");
  const History a = read_history(one_go.folder + "/history.h5"),
                b = read_history(base.folder + "/history.h5");
  BOOST_TEST((a.columns[0].size() > 50 && a.columns == b.columns), "the same history");
  for (std::size_t c = 0; c < a.names.size(); ++c)
    if (a.names[c] == "mesh_change_work")
      BOOST_TEST((a.columns[c].front() != a.columns[c].back()), "the mesh has changed");
  PvdSeries volumes(base.folder + "/volume.pvd");
  volumes.load();
  BOOST_TEST((volumes.entries().size() == 3 && volumes.entries()[1].second == "volume_evaluated.vtu" &&
              fs::exists(base.folder + "/volume_evaluated.vtu")),
             "the mesh at the start, at the place of evaluation and at the end");
  const Summary stopped = read_summary(base.folder + "/summary.json");
  for (const char *key :
       {"normal_force_N", "max_pressure_Pa", "creepage", "energy_error", "max_von_mises_Pa"})
    BOOST_TEST((get_figure(whole, key) == get_figure(stopped, key)), std::string("the same ") + key);
  BOOST_TEST(whole.energy_error < 1e-3, "the energy balance holds");
}
