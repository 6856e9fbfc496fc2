#pragma once

#include <string>

namespace wheelrail
{
  /// The path of a file that belongs to the program, such as "report/report.py". It is found from where the
  /// executable lies, so that build folder and installed program may be moved: in share/wheelrail beside the
  /// executable or beside its folder. Throws RunError, with the places looked at, when it is in neither.
  std::string
  shared_file(const std::string &name);
} // namespace wheelrail
