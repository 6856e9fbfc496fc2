#pragma once

#include <wheelrail/wheel/halfspace_case.h>

#include <functional>
#include <optional>
#include <string>

namespace wheelrail
{
  /// Why `solve` has no answer, an InputError or a RunError in words; nothing where it has one.
  std::string
  fault_of(const std::function<void()> &solve);

  /// Calls `solve` with the bodies of the scene. Half-space/Bodies = auto becomes real, or half-spaces where
  /// these cannot be: sections that cannot be meshed, a contact beside their tables. Returns why, or nothing.
  /// What `solve` throws with bodies that were asked for is thrown.
  std::string
  solve_with_bodies(Scene &scene, const std::function<void()> &solve);

  /// The contact of the true bodies of a scene under a load; nothing where their solution is not exact.
  /// Throws as solve_wheel_rail().
  std::optional<WheelRailSolution>
  solve_true_bodies(Scene scene, const SceneGeometry &geometry, const WheelRailLoad &load);

  /// Solves half-spaces under the load of true bodies and adds their figures to those of the bodies:
  /// "halfspace_max_pressure_Pa" and so on, and "relative_difference_max_pressure", of the bodies against
  /// half-spaces, as in the summary of a run. Nothing where half-spaces do not touch.
  void
  add_halfspaces(const Scene         &scene,
                 const SceneGeometry &geometry,
                 const WheelRailLoad &load,
                 Summary             &bodies);

  /// The gap of the model in one line: half-spaces beside true bodies, or these beside half-spaces; empty
  /// where there is no other model.
  std::string
  model_beside(const Summary &results);
} // namespace wheelrail
