#pragma once

#include <wheelrail/contactfiles/printed_elements.h>
#include <wheelrail/contactfiles/wheel_rail_case.h>

#include <string>
#include <vector>

namespace wheelrail
{
  /// A line of numbers in columns of twelve characters.
  std::string
  printed_row(const std::vector<double> &values);

  /// Such a line under its title, if it has one, and the names of its columns.
  std::string
  printed_block(const std::string &title, const std::string &names, const std::vector<double> &values);

  /// The names of the constants of a friction law (L).
  const char *
  law_heading(int law);

  /// Forces, statistics and, as the digit O asks, elements of a solution.
  std::string
  solution_lines(const ContactCase &one, const HalfspaceSolution &s, const PrintedPatch &patch);

  /// The blocks of a patch of module 1, its number counted from 1.
  std::string
  patch_lines(const ContactCase &one, const WheelRailPatch &p, std::size_t number);
} // namespace wheelrail
