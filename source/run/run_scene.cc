#include <wheelrail/run/passages.h>
#include <wheelrail/run/run_scene.h>

namespace wheelrail
{
  int
  run_scene(const Scene &scene, const SceneGeometry &geometry, const RunOptions &options)
  {
    return scene.several_passages() ? run_passages(scene, geometry, options)
                                    : run_simulation(scene, geometry, options);
  }
} // namespace wheelrail
