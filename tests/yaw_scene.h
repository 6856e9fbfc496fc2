#pragma once

// A wheelset with yaw on coarse cells, and its figures.

#include <wheelrail/output/summary.h>

#include "check.h"
#include "small_scene.h"
#include "stopped_runs.h"

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
    check(run(scene, false) == 0, scene.title + ": the run ends");
    const wheelrail::Summary summary = wheelrail::read_summary(scene.folder + "/summary.json");
    check(summary.energy_error < 5e-3, scene.title + ": the energy balance holds");
    return summary;
  }
} // namespace test
