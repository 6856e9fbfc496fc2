#include <wheelrail/base/interrupt.h>
#include <wheelrail/run/passages.h>
#include <wheelrail/run/run_scene.h>
#include <wheelrail/wheel/coarse_halfspaces.h>

namespace wheelrail
{
  int
  run_scene(const Scene &given, const SceneGeometry &geometry, const RunOptions &options)
  {
    const Scene scene = scene_of_run(given);
    save_when_interrupted();
    return scene.several_passages() ? run_passages(scene, geometry, options)
                                    : run_simulation(scene, geometry, options);
  }
} // namespace wheelrail
