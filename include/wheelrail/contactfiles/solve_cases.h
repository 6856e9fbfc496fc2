#pragma once

#include <wheelrail/contactfiles/case_points.h>
#include <wheelrail/contactfiles/case_problem.h>
#include <wheelrail/contactfiles/wheel_rail_case.h>
#include <wheelrail/halfspace/kernels.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace wheelrail
{
  /// A solved case, in the axes of its file.
  struct CaseSolution
  {
    HalfspaceSolution                     solution;
    std::optional<HertzContact>           hertz;  ///< of IPOTCN < 0
    std::vector<std::vector<PointStress>> points; ///< below the surface, of each block (S = 1 to 3)
  };

  /// Half a turn about the normal: vectors in the plane change sign, moments and spin do not.
  void
  turn_solution(HalfspaceSolution &solution);

  /// The state on another grid of equal elements, shifted by whole ones; nothing where it has no element.
  HalfspaceSolution
  on_grid(const HalfspaceSolution &state, const HalfspaceGrid &grid);

  /// What became of a case.
  struct CaseResult
  {
    std::vector<std::string>     refused;    ///< sentences; empty: it is computed, or was to be checked only
    std::optional<CaseSolution>  solved;     ///< of module 3
    std::optional<WheelRailCase> wheel_rail; ///< of module 1
  };

  /// What later cases of a contact go on from, and begin with.
  struct CaseState
  {
    std::optional<HalfspaceSolution>  before, last; ///< what the last case went on from, and its result
    std::optional<WheelRailCase>      before_wheel, last_wheel; ///< the same of module 1
    bool                              known = true;             ///< no case is missing
    std::shared_ptr<HalfspaceKernels> kernels;                  ///< influence functions of the last case
    WheelRailStart                    start;                    ///< the same of module 1
    bool                              warm = false;             ///< begin with the tractions of the last case
  };

  /// Solves a case of module 3 without refusals(). `previous`, in the axes of its file: the state from which
  /// shifts and transient rolling go on, null: none. With the approach and relative forces given, the normal
  /// force is found first; for unlike materials both are repeated until the force holds to 1e-6.
  CaseSolution
  solve_case(const ContactCase &one, const HalfspaceSolution *previous, CaseState &state);
  CaseSolution
  solve_case(const ContactCase &one, const HalfspaceSolution *previous = nullptr);

  /// Solves a case and moves its state on, or says why not. Shifts and transient rolling go on from the case
  /// before (P = 0), from its pressures (1), from nothing (2), or from where the case before went on (3);
  /// where that one is missing, the case is refused.
  CaseResult
  solve_next_case(const ContactCase &one, CaseState &state);

  /// Solves the cases of a file in their order; once a signal has come, only those before.
  std::vector<CaseResult>
  solve_cases(const std::vector<ContactCase> &cases);
} // namespace wheelrail
