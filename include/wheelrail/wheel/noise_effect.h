#pragma once

#include <wheelrail/wheel/halfspace_case.h>

namespace wheelrail
{
  /// By what shares the noise in measured profiles and irregularities may move the pressure and the patch:
  /// the contact is solved again, by half-spaces under `normal_force` [N] on elements of at least 0.8 mm, for
  /// others of the profiles that the points leave possible (drawn()); twice the root mean square of the
  /// changes, infinity where one does not touch.
  NoiseEffect
  noise_effect(const Scene &scene, const SceneGeometry &geometry, double normal_force);

  /// That of a solution, under the sum of its forces.
  void
  find_noise_effect(const Scene &scene, const SceneGeometry &geometry, WheelRailSolution &result);
} // namespace wheelrail
