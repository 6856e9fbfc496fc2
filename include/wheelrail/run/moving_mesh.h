#pragma once

#include <wheelrail/run/run_state.h>

namespace wheelrail
{
  // What a run takes from mesh to mesh. Without a moving window none of these changes a mesh.

  /// Moves the window on when the wheel has come to another block; whether it has. Collective.
  bool
  follow_wheel(RunState &run);

  /// Gives the window of a resumed run the path to the scene's Run/Rolling distance. Collective.
  void
  lengthen_path(RunState &run);
} // namespace wheelrail
