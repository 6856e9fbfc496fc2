#pragma once

#include <wheelrail/scene/scene.h>
#include <wheelrail/solid/part.h>
#include <wheelrail/track/track_support.h>

#include <mpi.h>

namespace wheelrail
{
  /// Pads and sleepers of a scene; `farther` [m]: how much farther along the rail the wheel starts, whose
  /// contact is then at Z = 0.
  TrackData
  track_data(const Scene &scene, double farther = 0);

  /// What holds and loads the bodies of a scene beside contact and axle, the same for time loop and static
  /// solutions: supports of the rail, damped ends, weight of the wheel.
  SceneParts
  scene_parts(const Scene &scene, double farther, MPI_Comm communicator);
} // namespace wheelrail
