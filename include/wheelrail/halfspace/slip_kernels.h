#pragma once

#include <wheelrail/halfspace/influence.h>

#include <vector>

namespace wheelrail
{
  /// The slip of tangential tractions on one grid: s = w + B t, with B = A / step for a shift or one step of
  /// transient rolling, B = (A - A') / step for steady rolling; A' gives the displacement at the place that
  /// lies one step further along rolling (where the material was one step before).
  struct SlipKernels
  {
    InfluenceProducts::Spectrum xx, xy, yy; ///< of B [1/Pa]
    /// The inverse of the 2 x 2 symbol of A, which is real, on the periodic doubled grid, for preconditioning
    /// [Pa/m].
    std::vector<double> inverse_xx, inverse_xy, inverse_yy;
    double              diagonal = 0; ///< B of an element on itself [1/Pa]
    double              step     = 0; ///< [m]
    bool                steady   = false;
  };

  SlipKernels
  slip_kernels(InfluenceProducts        &products,
               const HalfspaceConstants &constants,
               const HalfspaceGrid      &grid,
               double                    step,
               bool                      steady);
} // namespace wheelrail
