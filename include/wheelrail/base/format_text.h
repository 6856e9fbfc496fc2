#pragma once

#include <cstdio>
#include <string>

namespace wheelrail
{
  /// A line of text as by std::printf, at most 399 characters.
  template <typename... Arguments>
  std::string
  text(const char *format, const Arguments... arguments)
  {
    char buffer[400];
    std::snprintf(buffer, sizeof buffer, format, arguments...);
    return buffer;
  }
} // namespace wheelrail
