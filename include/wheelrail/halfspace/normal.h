#pragma once

#include <wheelrail/halfspace/kernels.h>
#include <wheelrail/halfspace/problem.h>
#include <wheelrail/halfspace/tangential.h>

#include <functional>
#include <vector>

namespace wheelrail
{
  /// The pressure that keeps two half-spaces apart where they would overlap.
  struct NormalContact
  {
    std::vector<double> pressure;       ///< [Pa], in: first guess (empty: none), never negative
    std::vector<double> displacement;   ///< of the pressure [m]
    double              approach   = 0; ///< [m], in: the given one unless the force is given
    int                 iterations = 0;
    double              residual   = 0; ///< largest gap in the contact or overlap outside, over the approach
    bool                converged  = false;
  };

  /// The displacement of a pressure [m]: a symmetric, positive product.
  using NormalProduct =
    std::function<void(const std::vector<double> &pressure, std::vector<double> &displacement)>;

  /// Finds p >= 0 with gap e = distance - approach + A p >= 0 and e p = 0, where A p is `product`; with
  /// force_given also sum(p) dx dy = force, and the approach is found. Conjugate gradients with projection on
  /// p >= 0 (Polonsky and Keer 1999).
  void
  solve_normal(const NormalProduct       &product,
               const HalfspaceGrid       &grid,
               const std::vector<double> &distance,
               bool                       force_given,
               double                     force,
               double                     tolerance,
               int                        max_iterations,
               NormalContact             &contact);

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
