#pragma once

#include <wheelrail/base/simd.h>

#include <array>

namespace wheelrail
{
  /// Cauchy's stress F S F^T / det F of a displacement gradient H (row-major) and a second
  /// Piola-Kirchhoff stress S; stresses as xx, yy, zz, yz, xz, xy [Pa].
  std::array<double, 6>
  cauchy_stress(const std::array<double, 9> &H, const Simd<1> (&S)[6]);

  /// Equivalent stress of von Mises (1913) of six stresses in this order [Pa].
  double
  von_mises(const double *stress);
} // namespace wheelrail
