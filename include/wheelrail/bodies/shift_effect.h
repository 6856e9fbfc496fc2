#pragma once

#include <wheelrail/wheel/halfspace_case.h>

namespace wheelrail
{
  /// How much the peak pressure of half-spaces changes over the lateral shifts by which wheel and rail
  /// themselves deflect under the load, about 0.2 mm per 100 kN to either side: the larger of the pressures
  /// at both ends over the smaller one, less 1. Up to a fifth where the radii change little; of a head's
  /// corner, where 0.1 mm decide whether tread or flange root bears, several tenths, and there half-spaces
  /// are no answer (doc/manual/compare.md). Two normal problems on elements of 0.8 mm, a few hundredths of a
  /// second. `normal_force`: of all patches [N].
  double
  shift_effect(const Scene &scene, const SceneGeometry &geometry, double normal_force);

  /// Sets `shift_effect` of a solution of half-spaces; true bodies, whose pose is a result, stay without.
  void
  find_shift_effect(const Scene &scene, const SceneGeometry &geometry, WheelRailSolution &result);

  /// The same, and `bodies_effect`: the peak pressure of half-spaces over that of the true bodies under the
  /// forces that they carry, less 1, which includes the lateral force, load and elastic constants; NaN where
  /// a position is given by hand or true bodies have no answer. Takes as long as they do, some tenths of a
  /// second.
  void
  hold_against_bodies(const Scene &scene, const SceneGeometry &geometry, WheelRailSolution &result);
} // namespace wheelrail
