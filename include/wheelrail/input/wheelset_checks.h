#pragma once

#include <wheelrail/input/cross_checks.h>
#include <wheelrail/scene/scene.h>

namespace wheelrail
{
  /// Adds what is wrong, or to be warned of, with curve, cant and both wheels of a wheelset: entries that
  /// contradict each other, and a velocity at which the curve overturns what rests on the axle.
  void
  check_wheelset(const Scene &scene, Findings &found);
} // namespace wheelrail
