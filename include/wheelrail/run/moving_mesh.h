#pragma once

#include <wheelrail/run/run_state.h>

namespace wheelrail
{
  // What a run takes from mesh to mesh. Without a moving window none of these changes a mesh.

  /// From the mesh of the start to the same cells of a moving window. Collective.
  void
  use_window(RunState &run);

  /// Moves the window on when the wheel has come to another block; whether it has. Collective.
  bool
  follow_wheel(RunState &run);

  /// Gives the window of a resumed run the way to the scene's Run/Rolling distance. Collective.
  void
  lengthen_way(RunState &run);

  /// From a moving window to a forest of the same cells, which static solutions need. Collective.
  void
  use_forest(RunState &run);
} // namespace wheelrail
