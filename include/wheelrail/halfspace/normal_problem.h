#pragma once

#include <wheelrail/halfspace/kernels.h>
#include <wheelrail/halfspace/normal.h>
#include <wheelrail/halfspace/tangential.h>

namespace wheelrail
{
  /// Pressures [Pa] and approach [m] under the tractions [Pa] of the last round (empty: none). `coupled`:
  /// tractions move the surfaces along the normal, too (unlike materials). Conformal contacts have normals of
  /// their own in each element (`normal_cosine`). `normal`: in, the first guess.
  void
  solve_normal_problem(const HalfspaceProblem &problem,
                       HalfspaceKernels       &kernels,
                       bool                    coupled,
                       const VectorField      &traction,
                       NormalContact          &normal);
} // namespace wheelrail
