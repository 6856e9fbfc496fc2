#pragma once

#include <wheelrail/contactfiles/solve_cases.h>
#include <wheelrail/output/figure_table.h>

#include <cstddef>
#include <iosfwd>
#include <vector>

namespace wheelrail
{
  /// One row a case of module 3 that is solved, in SI units: its place in the file and its line, forces on
  /// body 1, moment about the normal, approach, creepages or shifts, peaks and areas.
  FigureTable
  case_table(const std::vector<ContactCase> &cases, const std::vector<CaseResult> &results);

  /// One row a point below the surface, in SI units: case, patch and block, place, stresses.
  FigureTable
  point_table(const std::vector<CaseResult> &results);

  /// One row a case of module 1 that is solved, in SI units, CONTACT's axes and signs: its place in the file
  /// and its line, height and pitch rate of the wheelset, forces on the rail, number of patches.
  FigureTable
  wheel_rail_table(const std::vector<ContactCase> &cases, const std::vector<CaseResult> &results);

  /// One row a patch of these: place, angle, creepages, forces, approach, peaks, areas.
  FigureTable
  patch_table(const std::vector<ContactCase> &cases, const std::vector<CaseResult> &results);

  /// On the screen: heading and a line a case of module 3, or a patch of module 1.
  void
  print_heading(std::ostream &out);
  void
  print_case(std::size_t place, const ContactCase &one, const HalfspaceSolution &s, std::ostream &out);
  void
  print_wheel_rail_heading(std::ostream &out);
  void
  print_wheel_rail(std::size_t place, const ContactCase &one, const WheelRailCase &solved, std::ostream &out);
} // namespace wheelrail
