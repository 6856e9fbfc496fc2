#pragma once

#include <wheelrail/halfspace/tangential.h>

#include <vector>

// The plastic layer between the bodies (CONTACT's M = 4): its yield stress and plastic shift are brought by
// the material, one element a step in rolling, and stay where they are in a shift.

namespace wheelrail
{
  /// Yield stress of the layer where the step begins, per element [Pa]; empty without a layer.
  std::vector<double>
  brought_yield(const HalfspaceProblem &problem);

  /// Yield stress and plastic shift [m] of the layer after the step; takes the plastic part off the slip.
  void
  set_layer_state(const HalfspaceProblem &problem,
                  const TangentialState  &tangential,
                  HalfspaceSolution      &solution);
} // namespace wheelrail
