#pragma once

#include <wheelrail/halfspace/problem.h>
#include <wheelrail/halfspace/slip_kernels.h>

#include <array>
#include <vector>

namespace wheelrail
{
  /// (x, y) parts of a vector field on the grid.
  using VectorField = std::array<std::vector<double>, 2>;

  /// An element that ran into the contact within a step longer than itself, the one before the leading edge
  /// of its row, and the share of the step that it took part in.
  struct RunIn
  {
    int    element = 0, edge = 0;
    double share = 1;
  };

  /// What is asked of the tangential problem: |t| <= bound, s = 0 where |t| < bound, else t = -bound s / |s|.
  struct TangentialTask
  {
    const SlipKernels    *kernels = nullptr;
    const AddedInfluence *added   = nullptr; ///< what the bodies deflect beyond half-spaces, or nothing
    HalfspaceGrid         grid;
    std::vector<double>   bound;      ///< mu p [Pa]; the contact is where it is positive
    VectorField           rigid_slip; ///< without the creepages below [-]
    /// Their slip counts from the leading edge on, over the share of the step.
    std::vector<RunIn>    run_in;
    const SlipKernels    *displacement = nullptr; ///< in steady rolling: A / step
    std::array<bool, 2>   force_given{{false, false}};
    std::array<double, 2> force{{0, 0}}; ///< [N]
    double                tolerance = 1e-5;
    int                   max_steps = 60;
    /// Of a layer that yields: the yield stress that the material in each element has at the beginning of the
    /// step (in steady rolling, where it runs in) [Pa]; empty: none. Its rise with plastic slip [Pa], its
    /// least value [Pa], and whether what yields ahead hardens what follows (steady rolling).
    std::vector<double> yield;
    double              hardening = 0, least_yield = 0;
    bool                carried = false;
  };

  struct TangentialState
  {
    VectorField           traction;         ///< in: first guess (empty: none)
    std::array<double, 2> creepage{{0, 0}}; ///< in: given values, or first guess where the force is given
    VectorField           slip;             ///< plastic slip of a layer included
    std::vector<char>     slipping;         ///< per element of the grid; 2: the layer yields instead
    std::vector<double>   yield;            ///< of the layer at the end of the step [Pa]
    std::vector<double>   plastic;          ///< share of the slip that is plastic
    int                   newton_steps = 0, krylov_iterations = 0;
    double residual  = 0; ///< rms of t - P(t - s / B_II) over the largest P; P projects on |t| <= bound
    bool   converged = false;
  };

  /// Solves the task by Newton steps on t = P(t - s / B_II) with sets of adhesion and slip and the slip's
  /// direction linearised (semi-smooth Newton), each step by preconditioned GMRES; by proximal points where
  /// that does not converge, then by interval halving of the creepage of one given force. The tractions
  /// returned keep |t| <= bound.
  void
  solve_tangential(InfluenceProducts &products, const TangentialTask &task, TangentialState &state);

  /// The elements that run into a contact with these pressures [Pa] within a `step` of several elements [m];
  /// none where a step is one element, and in a shift.
  std::vector<RunIn>
  elements_run_in(const HalfspaceProblem &problem, double step, const std::vector<double> &pressure);
} // namespace wheelrail
