#include <wheelrail/dynamics/supports.h>
#include <wheelrail/model/scene_parts.h>

#include <memory>
#include <vector>

namespace wheelrail
{
  SceneParts
  scene_parts(const Scene &scene, const double farther, MPI_Comm communicator)
  {
    SceneParts parts;
    if (scene.support.kind == RailSupport::clamped_foot)
      parts.push_back(std::make_unique<Supports>(std::vector<Boundary>{Boundary::foot, Boundary::end}));
    add_track(scene, farther, communicator, parts);
    parts.push_back(std::make_unique<Weight>(Body::wheel, scene.gravity));
    return parts;
  }
} // namespace wheelrail
