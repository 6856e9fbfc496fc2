#pragma once

#include <wheelrail/application/scene.h>
#include <wheelrail/halfspace/problem.h>
#include <wheelrail/output/fields.h>

namespace wheelrail
{
  /// Elastic constants of one body; half-spaces have no yield stress.
  HalfspaceBody
  halfspace_body(const MaterialData &material);

  /// The friction law of the scene.
  HalfspaceFriction
  halfspace_friction(const Scene &scene);

  /// A solution in the layout and with the signs of a run's patch: lateral fastest, tractions on the rail
  /// (body 1), slip of the wheel against the rail.
  PatchFields
  halfspace_patch(const HalfspaceSolution &solution);
} // namespace wheelrail
