#pragma once

namespace wheelrail
{
  /// Forces over small creepages of an elliptic contact: Fx = -G ab C11 xi, Fy = -G ab (C22 eta + sqrt(ab)
  /// C23 phi) (Kalker 1967; table E3 of Kalker 1990). [-]
  struct KalkerCoefficients
  {
    double c11 = 0, c22 = 0, c23 = 0;
  };

  /// Of the ratio a/b of semi-axes along and across rolling (0.1 to 10; beyond: those of the end) and of
  /// Poisson's ratio, between the rows of the table.
  KalkerCoefficients
  kalker_coefficients(double ratio, double poisson_ratio);
} // namespace wheelrail
