#include <wheelrail/base/interrupt.h>
#include <wheelrail/run/passages.h>
#include <wheelrail/run/run_scene.h>

namespace wheelrail
{
  int
  run_scene(const Scene &scene, const SceneGeometry &geometry, const RunOptions &options)
  {
    save_when_interrupted();
    return scene.several_passages() ? run_passages(scene, geometry, options)
                                    : run_simulation(scene, geometry, options);
  }
} // namespace wheelrail
