#pragma once

#include <string>

namespace wheelrail
{
  /// Writes `text` into an open file, such as STDOUT_FILENO, with one call of write() for each of its lines:
  /// where errors and output, or several processes, share a file or a pipe, their lines follow each other
  /// whole. What std::cout still holds is written before. A file that takes nothing (a closed pipe, a full
  /// disk) is no fault.
  void
  print(int file, const std::string &text);
} // namespace wheelrail
