#pragma once

#include <wheelrail/contact/surface_filter.h>
#include <wheelrail/solid/element_blocks.h>

#include <array>

namespace wheelrail
{
  /// Ratios of the discrete to the exact response of a half-space surface, minus one.
  struct SurfaceResponse
  {
    double normal;        ///< normal displacement to normal load
    double parallel;      ///< tangential, along the wave vector
    double perpendicular; ///< tangential, across it
  };

  /// Response of an endless half-space of unit cubes with the element `stiffness` (24 x 24, row-major,
  /// lexicographic nodes of a cube of edge 1 m) to nodal forces exp(i k x) on its surface, against
  /// 2 (1 - nu^2) / (E k) for normal and parallel and 2 (1 + nu) / (E k) for perpendicular tractions
  /// (the harmonic solutions of Boussinesq's and Cerruti's problems, as in Johnson, 1985).
  /// kx and ky are wave numbers times the edge.
  SurfaceResponse
  surface_response(const std::array<double, 24 * 24> &stiffness,
                   const Elasticity                  &material,
                   double                             kx,
                   double                             ky);

  /// The filter that takes the error of second order in the cell size out of the normal response (mean
  /// over wave vectors along and at 45 degrees to the cells), and out of the tangential one for wave
  /// vectors across the traction. See doc/theory/contact.md.
  SurfaceFilter
  surface_filter(const std::array<double, 24 * 24> &stiffness, const Elasticity &material);
} // namespace wheelrail
