#pragma once

#include <wheelrail/halfspace/problem.h>

#include <string>

namespace wheelrail
{
  /// The problem as input of the program CONTACT (basic contact module; open version, revision 2707, lengths
  /// in mm): grid, undeformed distance and rigid slip of every element, forces, materials, steady rolling.
  /// Body 1 and all signs are those of the problem. Throws InputError for friction that depends on speed.
  std::string
  contact_input(const HalfspaceProblem &problem, const std::string &title);
} // namespace wheelrail
