#pragma once

#include <wheelrail/run/run_state.h>

namespace wheelrail
{
  /// Brings the rate of a wheel that is driven by a torque to the balance of that torque, where the axle's
  /// torque has a ramp (AxleData): half a length of the patch after the start, and once more at a whole one.
  /// The creepage that half-spaces predict is some per cent off for bodies of finite size, and the inertia of
  /// the wheel would take some ten lengths of the patch to correct it. Newton's method on the force, with the
  /// slope of the creep curve (CreepScale), takes a step of it. To be called after each step that came from
  /// `before` [m] rolled, when the row of that step has been added. Collective.
  void
  run_in(RunState &run, double before);
} // namespace wheelrail
