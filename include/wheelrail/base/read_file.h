#pragma once

#include <string>

namespace wheelrail
{
  /// The whole file as a string; throws RunError naming the file and the reason, also when it is no ordinary
  /// file.
  std::string
  read_whole_file(const std::string &path);
} // namespace wheelrail
