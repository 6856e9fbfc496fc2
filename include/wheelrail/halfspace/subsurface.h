#pragma once

#include <wheelrail/halfspace/problem.h>

#include <vector>

namespace wheelrail
{
  /// Stresses in axes x, y, n of the contact frame [Pa], tension positive.
  struct HalfspaceStress
  {
    double xx = 0, yy = 0, nn = 0, xy = 0, xn = 0, yn = 0;

    double
    von_mises() const;
  };

  /// A point inside a body: place in the contact plane and depth below the surface [m].
  struct SubsurfacePoint
  {
    double x = 0, y = 0, depth = 0;
  };

  enum class HalfspaceSide
  {
    body1,
    body2
  };

  /// The stresses at the points in one body under the pressure and tractions of a solution: closed
  /// integrals over every loaded element (potentials of Boussinesq and Cerruti, Love 1929, Johnson 1985,
  /// section 3.2). On the surface (depth 0) the stresses are infinite on the edges between elements of
  /// different traction: take element centres there. Throws InputError for a negative depth.
  std::vector<HalfspaceStress>
  subsurface_stresses(const HalfspaceSolution            &solution,
                      const HalfspaceBody                &body,
                      HalfspaceSide                       side,
                      const std::vector<SubsurfacePoint> &points);

  /// Throws InputError for a negative depth [m].
  void
  check_depth(double depth);
} // namespace wheelrail
