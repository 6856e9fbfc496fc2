#pragma once

// A wheelset with yaw on coarse cells, and its figures.

#include <wheelrail/output/summary.h>

#include "near.h"
#include "read_output.h"
#include "small_scene.h"
#include "stopped_runs.h"

#include <filesystem>
#include <string>

namespace test
{
  constexpr double small_yaw = 2e-3; ///< [rad], of which some stick and some slide

  /// Free rolling with that yaw on cells of 4 mm.
  inline wheelrail::Scene
  yaw_scene(const std::string &name)
  {
    wheelrail::Scene scene     = small_scene(4e-3);
    scene.title                = "yaw, " + name;
    scene.yaw                  = small_yaw;
    scene.traction_coefficient = 0;
    scene.rail_length          = 0.4;
    scene.ticks                = 2;
    scene.volume_fields        = false;
    scene.checkpoint_interval  = 1e4;
    scene.folder               = "yaw_" + name;
    return scene;
  }

  /// Those of a run to its end.
  inline wheelrail::Summary
  figures_of_run(const wheelrail::Scene &scene)
  {
    BOOST_TEST(run(scene, false) == 0, scene.title + ": the run ends");
    const wheelrail::Summary summary = wheelrail::read_summary(scene.folder + "/summary.json");
    BOOST_TEST(summary.energy_error < 5e-3, scene.title + ": the energy balance holds");
    return summary;
  }

  /// A run that went to its end.
  struct EndedRun
  {
    wheelrail::Summary summary;
    wheelrail::History history;
  };

  /// Stops the run `parts` soon after its static start and once more before it ends; from the first stop
  /// `whole`, the same scene with another folder, goes on in one go. Their histories must be the same.
  inline EndedRun
  stopped_twice(const wheelrail::Scene &parts, const wheelrail::Scene &whole)
  {
    namespace fs = std::filesystem;
    BOOST_TEST(run(parts, false, 50) == 3, "interrupted soon after the static start");
    fs::remove_all(whole.folder);
    fs::copy(parts.folder, whole.folder, fs::copy_options::recursive);
    BOOST_TEST(run(whole, true) == 0, "gone on to the end in one go");
    EndedRun ended{wheelrail::read_summary(whole.folder + "/summary.json"), {}};
    BOOST_TEST(ended.summary.energy_error < 5e-3, "the energy balance holds");
    BOOST_TEST(run(parts, true, static_cast<unsigned long>(0.8 * ended.summary.time_steps)) == 3,
               "interrupted again");
    BOOST_TEST(run(parts, true) == 0, "gone on to the end");
    ended.history                = read_history(whole.folder + "/history.h5");
    const wheelrail::History two = read_history(parts.folder + "/history.h5");
    BOOST_TEST((ended.history.columns[0].size() > 50 && ended.history.columns == two.columns),
               "the same history, bit for bit");
    return ended;
  }
} // namespace test
