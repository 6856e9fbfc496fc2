#pragma once

#include <wheelrail/contactfiles/solve_cases.h>
#include <wheelrail/output/figure_table.h>
#include <wheelrail/wheel/halfspace_case.h>

#include <iosfwd>
#include <string>
#include <vector>

namespace wheelrail
{
  /// Steady rolling of a solved case of module 1 between true bodies (solve_bodies()): its profiles on
  /// standard bodies of wheel and rail, in its pose, with its drive, under the vertical force that its
  /// half-spaces carry. Throws InputError or RunError, in a sentence without file and line, for what these do
  /// not have or answer.
  WheelRailSolution
  solve_case_bodies(const ContactCase &one, const WheelRailCase &solved);

  /// One row a case of module 1 that is so solved, in SI units, CONTACT's axes and signs, forces on the rail:
  /// those of patch_table(), at the centre of pressure, and the peak pressure over that of the half-spaces,
  /// less 1. `without`: sentences on solved cases that have no such answer.
  FigureTable
  bodies_table(const std::vector<ContactCase> &cases,
               const std::vector<CaseResult>  &results,
               std::vector<std::string>       &without);

  /// The same on the screen, a line a case.
  void
  print_bodies(const FigureTable &table, std::ostream &out);
} // namespace wheelrail
