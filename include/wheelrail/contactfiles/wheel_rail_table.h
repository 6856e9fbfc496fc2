#pragma once

#include <wheelrail/contactfiles/solve_cases.h>
#include <wheelrail/output/figure_table.h>

#include <cstddef>
#include <iosfwd>
#include <vector>

namespace wheelrail
{
  /// One row a case of module 1 that is solved, in SI units, CONTACT's axes and signs: its place in the file
  /// and its line, height and pitch rate of the wheelset, forces on the rail, number of patches.
  FigureTable
  wheel_rail_table(const std::vector<ContactCase> &cases, const std::vector<CaseResult> &results);

  /// One row a patch of these: place, angle, creepages, forces, approach, peaks, areas.
  FigureTable
  patch_table(const std::vector<ContactCase> &cases, const std::vector<CaseResult> &results);

  /// The same on the screen, a line a patch.
  void
  print_wheel_rail_heading(std::ostream &out);
  void
  print_wheel_rail(std::size_t place, const ContactCase &one, const WheelRailCase &solved, std::ostream &out);
} // namespace wheelrail
