#pragma once

#include <string>

namespace wheelrail
{
  /// The text of a parameter file. Throws InputError when there is no such file (and names the
  /// nearest in that folder), when it is a folder, unreadable, empty, too large or not a text.
  std::string
  read_input_file(const std::string &path);
} // namespace wheelrail
