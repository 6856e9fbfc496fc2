#pragma once

#include <wheelrail/base/log.h>
#include <wheelrail/run/run_state.h>
#include <wheelrail/statics/unloading.h>

#include <optional>

namespace wheelrail
{
  /// The bodies of a run that may yield without their loads (unload()), with a line in the log; nothing of
  /// elastic ones, or when the unloading does not converge, which is said. Collective.
  std::optional<UnloadedBodies>
  take_loads_off(RunState &run, Log &log);
} // namespace wheelrail
