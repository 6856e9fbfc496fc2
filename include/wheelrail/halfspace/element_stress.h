#pragma once

#include <wheelrail/halfspace/subsurface.h>

namespace wheelrail
{
  /// Derivatives of W, the integral over a rectangle of z ln(rho + z) - rho, rho the distance to the point
  /// (Love 1929; Johnson 1985, section 3.2). The integral over a rectangle is the sum over its corners with
  /// signs that alternate: each holds what its corners give.
  struct PotentialDerivatives
  {
    double xxx = 0, xxy = 0, xyy = 0, yyy = 0;
    double xxz = 0, xyz = 0, yyz = 0, xzz = 0, yzz = 0, zzz = 0;
    double xxxz = 0, xxyz = 0, xyyz = 0, yyyz = 0;
    double xxzz = 0, xyzz = 0, yyzz = 0, xzzz = 0, yzzz = 0, zzzz = 0;
  };

  /// Of a corner at the distance (x, y) and a point at the depth z [m].
  PotentialDerivatives
  corner_derivatives(double x, double y, double z);

  /// Of the rectangle between corners: those on the diagonal through the largest x and y, less the others.
  PotentialDerivatives
  rectangle_derivatives(const PotentialDerivatives &far_far,
                        const PotentialDerivatives &far_near,
                        const PotentialDerivatives &near_far,
                        const PotentialDerivatives &near_near);

  /// Adds the stresses [Pa] under tractions (qx, qy) and pressure p [Pa] on the rectangle in a body with the
  /// Poisson ratio `nu` at the depth z [m], n into the body.
  void
  add_stress(const PotentialDerivatives &d,
             double                      nu,
             double                      z,
             double                      qx,
             double                      qy,
             double                      p,
             HalfspaceStress            &s);
} // namespace wheelrail
