#pragma once

#include <wheelrail/halfspace/problem.h>

#include <string>
#include <vector>

namespace wheelrail
{
  /// A line of numbers with up to `digits` digits, and what they are.
  std::string
  contact_line(const std::vector<double> &numbers, const std::string &names = "", int digits = 9);

  /// The remarks at the head of an input: the title in one line, the version of CONTACT, `about`.
  std::string
  contact_head(const std::string &title, const std::string &about);

  /// The problem as input of the program CONTACT (basic contact module; open version, revision 2707, lengths
  /// in mm): grid, undeformed distance and rigid slip of every element, forces, materials, steady rolling.
  /// Body 1 and all signs are those of the problem. Throws InputError for friction that depends on speed.
  std::string
  contact_input(const HalfspaceProblem &problem, const std::string &title);
} // namespace wheelrail
