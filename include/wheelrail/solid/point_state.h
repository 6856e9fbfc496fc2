#pragma once

#include <wheelrail/base/simd.h>
#include <wheelrail/solid/element_blocks.h>

#include <array>
#include <vector>

namespace wheelrail
{
  /// Second Piola-Kirchhoff stress S [Pa] of an integration point (0 in the form `reduced`) of a packed
  /// element at Green's strain E, both xx, yy, zz, yz, xz, xy, with the history of the last step.
  void
  point_stress(const ElementBlocks &blocks,
               std::size_t          element,
               int                  point,
               const Simd<1> (&E)[6],
               Simd<1> (&S)[6]);

  /// Accumulated plastic strain of each element [1], the largest of its integration points; zeros in
  /// elastic bodies.
  std::vector<double>
  element_plastic_strain(const ElementBlocks &blocks);

  /// Cauchy's stress F S F^T / det F of a displacement gradient H (row-major) and a second
  /// Piola-Kirchhoff stress S; stresses as xx, yy, zz, yz, xz, xy [Pa].
  std::array<double, 6>
  cauchy_stress(const std::array<double, 9> &H, const Simd<1> (&S)[6]);

  /// Equivalent stress of von Mises (1913) of six stresses in this order [Pa].
  double
  von_mises(const double *stress);
} // namespace wheelrail
