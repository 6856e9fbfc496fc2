#pragma once

#include <wheelrail/contactfiles/case_problem.h>
#include <wheelrail/contactfiles/wheel_rail_case.h>

#include <optional>
#include <string>
#include <vector>

namespace wheelrail
{
  /// A solved case, in the axes of its file.
  struct CaseSolution
  {
    HalfspaceSolution           solution;
    std::optional<HertzContact> hertz; ///< of IPOTCN < 0
  };

  /// Half a turn about the normal: vectors in the plane change sign, moments and spin do not.
  void
  turn_solution(HalfspaceSolution &solution);

  /// The state on another grid of equal elements, shifted by whole ones; nothing where it has no element.
  HalfspaceSolution
  on_grid(const HalfspaceSolution &state, const HalfspaceGrid &grid);

  /// Solves a case of module 3 without refusals(). `previous`, in the axes of its file: the state from which
  /// shifts and transient rolling go on, null: none. With the approach and relative forces given, the normal
  /// force is found first; for unlike materials both are repeated until the force holds to 1e-6.
  CaseSolution
  solve_case(const ContactCase &one, const HalfspaceSolution *previous = nullptr);

  /// What became of a case.
  struct CaseResult
  {
    std::vector<std::string>     refused;    ///< sentences; empty: it is computed, or was to be checked only
    std::optional<CaseSolution>  solved;     ///< of module 3
    std::optional<WheelRailCase> wheel_rail; ///< of module 1
  };

  /// Solves the cases of a file in their order; shifts and transient rolling go on from the case before (P =
  /// 0), from its pressures (1), from nothing (2), or from where the case before went on (3). Where such a
  /// case follows one that is refused, it is refused, too.
  std::vector<CaseResult>
  solve_cases(const std::vector<ContactCase> &cases);
} // namespace wheelrail
