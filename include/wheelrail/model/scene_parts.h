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

  /// Adds the pads and sleepers of a scene and the damped ends of its rail, where it has them. `farther` [m]:
  /// how much farther along the rail the wheel starts, whose contact is then at Z = 0. Of the room track.
  void
  add_track(const Scene &scene, double farther, MPI_Comm communicator, SceneParts &parts);
} // namespace wheelrail
