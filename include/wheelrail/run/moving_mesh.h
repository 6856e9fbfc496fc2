#pragma once

#include <wheelrail/base/log.h>
#include <wheelrail/dynamics/rolling.h>
#include <wheelrail/model/model.h>
#include <wheelrail/sampling/residual.h>
#include <wheelrail/wheelset/axle.h>

#include <functional>
#include <optional>

namespace wheelrail
{
  /// What a run takes from mesh to mesh. Without a moving window none of the functions below changes a mesh.
  struct MovingParts
  {
    const Scene &scene;
    Model       &model;
    Rolling     &rolling;
    const Axle  &axle;
    MPI_Comm     communicator;
  };

  /// From the mesh of the start to the same cells of a moving window. Collective.
  void
  use_window(const MovingParts &run);

  /// Moves the window on when the wheel has come to another block; whether it has. Collective.
  bool
  follow_wheel(const MovingParts &run);

  /// Gives the window of a resumed run the way to the scene's Run/Rolling distance. Collective.
  void
  lengthen_way(const MovingParts &run);

  /// What the run leaves in bodies that may yield, once the loads are taken off (find_residual()); nothing of
  /// elastic ones, or when that fails, which is said. The mesh is then that of a forest with the same cells.
  /// `meanwhile` is called with the loads off. Collective.
  std::optional<Residual>
  take_loads_off(const MovingParts &run, Log &log, const std::function<void()> &meanwhile);
} // namespace wheelrail
