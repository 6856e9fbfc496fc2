#pragma once

#include <wheelrail/scene/scene.h>
#include <wheelrail/solid/part.h>

#include <mpi.h>

namespace wheelrail
{
  /// What holds and loads the bodies of a scene beside contact and axle, the same for time loop and static
  /// solutions: supports of the rail, damped ends, weight of the wheel.
  SceneParts
  scene_parts(const Scene &scene, double farther, MPI_Comm communicator);
} // namespace wheelrail
