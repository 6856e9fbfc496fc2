#pragma once

#include <string>

namespace wheelrail
{
  /// What is at `path` in place of an ordinary file, in words ("a folder", "a pipe", "a device", "a
  /// socket"); empty where there is an ordinary file, or nothing. Only ordinary files are read: a pipe may be
  /// waited for for ever, and a device may have no end.
  std::string
  other_than_a_file(const std::string &path);
} // namespace wheelrail
