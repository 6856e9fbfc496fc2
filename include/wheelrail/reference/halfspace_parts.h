#pragma once

#include <wheelrail/halfspace/problem.h>
#include <wheelrail/output/fields.h>
#include <wheelrail/scene/scene.h>

#include <functional>

namespace wheelrail
{
  /// A problem with materials, friction law and speed of the scene; half-spaces have no yield stress. Rail
  /// as body 1.
  HalfspaceProblem
  halfspace_problem(const Scene &scene);

  /// Solves the normal problem alone, with `lay_grid`, which sets grid and undeformed distance for an
  /// approach, called with ever larger ones until the contact keeps off the edge of the grid, `most`
  /// times beyond the first at most. The number of enlargements comes back in `enlargements`.
  HalfspaceSolution
  solve_on_growing_grid(HalfspaceProblem                  &problem,
                        double                             approach,
                        int                                most,
                        const std::function<void(double)> &lay_grid,
                        int                               &enlargements);

  /// solve_rolling(); also friction that falls with the slip velocity and does not carry the force asked for
  /// is an InputError.
  HalfspaceSolution
  solve_carried(const HalfspaceProblem &problem);

  /// A solution in the layout and with the signs of a run's patch: lateral fastest, tractions on the rail
  /// (body 1), slip of the wheel against the rail.
  PatchFields
  halfspace_patch(const HalfspaceSolution &solution);
} // namespace wheelrail
