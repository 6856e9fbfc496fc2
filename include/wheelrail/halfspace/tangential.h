#pragma once

#include <wheelrail/halfspace/influence.h>

namespace wheelrail
{
  /// The slip of tangential tractions on one grid: s = w + B t, with B = A / step for a shift or one step of
  /// transient rolling, B = (A - A') / step for steady rolling; A' gives the displacement at the place that
  /// lies one step further along rolling (where the material was one step before).
  struct SlipKernels
  {
    InfluenceProducts::Spectrum xx, xy, yy; ///< of B [1/Pa]
    /// The inverse of the 2 x 2 symbol of A on the periodic doubled grid, for preconditioning [Pa/m].
    InfluenceProducts::Spectrum inverse_xx, inverse_xy, inverse_yy;
    double                      diagonal = 0; ///< B of an element on itself [1/Pa]
    double                      step     = 0; ///< [m]
    bool                        steady   = false;
  };

  SlipKernels
  slip_kernels(InfluenceProducts        &products,
               const HalfspaceConstants &constants,
               const HalfspaceGrid      &grid,
               double                    step,
               bool                      steady);

  /// (x, y) parts of a vector field on the grid.
  using VectorField = std::array<std::vector<double>, 2>;

  /// What is asked of the tangential problem: |t| <= bound, s = 0 where |t| < bound, else t = -bound s / |s|.
  struct TangentialTask
  {
    const SlipKernels    *kernels = nullptr;
    HalfspaceGrid         grid;
    std::vector<double>   bound;      ///< mu p [Pa]; the contact is where it is positive
    VectorField           rigid_slip; ///< without the creepages below [-]
    std::array<bool, 2>   force_given{{false, false}};
    std::array<double, 2> force{{0, 0}}; ///< [N]
    double                tolerance = 1e-5;
    int                   max_steps = 60;
  };

  struct TangentialState
  {
    VectorField           traction;         ///< in: first guess (empty: none)
    std::array<double, 2> creepage{{0, 0}}; ///< in: given values, or first guess where the force is given
    VectorField           slip;
    int                   newton_steps = 0, krylov_iterations = 0;
    double residual  = 0; ///< rms of t - P(t - s / B_II) over the largest P; P projects on |t| <= bound
    bool   converged = false;
  };

  /// Solves the task by Newton steps on t = P(t - s / B_II) with sets of adhesion and slip and the slip's
  /// direction linearised (semi-smooth Newton), each step by preconditioned GMRES.
  void
  solve_tangential(InfluenceProducts &products, const TangentialTask &task, TangentialState &state);
} // namespace wheelrail
