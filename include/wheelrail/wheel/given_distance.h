#pragma once

#include <wheelrail/wheel/halfspace_case.h>

namespace wheelrail
{
  /// Whether the scene's Half-space/Undeformed distance is hertz, rollers or a file.
  bool
  distance_is_given(const HalfspaceSettings &scene);

  /// Whether the half-spaces of a scene need wheel and rail in touch: for their distance or for the weight of
  /// the wheel.
  bool
  needs_profiles(const HalfspaceSettings &scene);

  /// Solves steady rolling with the undeformed distance of Half-space/Undeformed distance: Hertzian
  /// (Hertz, 1882), of rollers (roller_distance.h) or from a file. Normal force (auto: static wheel load of
  /// the wheel that touches the rail) or approach are given, the longitudinal force is traction coefficient x
  /// normal force, or with Drive = rate the creepage is given; spin is sin(Contact angle) / Radius along.
  /// Rail as body 1, no inclination of the contact plane. `geometry` may be null unless needs_profiles().
  /// Throws InputError for a faulty file, for a force and an approach at once or neither.
  WheelRailSolution
  solve_given_distance(const Scene &scene, const SceneGeometry *geometry);
} // namespace wheelrail
