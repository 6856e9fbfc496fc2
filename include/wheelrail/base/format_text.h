#pragma once

#include <cstdio>
#include <string>
#include <vector>

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

  /// A text of the user as a message repeats it: control characters become "?", and what is longer
  /// than `most` bytes is cut and ends with "...". Letters of UTF-8 stay whole.
  std::string
  shown_text(const std::string &text, std::size_t most = 100);

  /// The parts of a text between separators, without the blanks around them; one empty part of an empty text.
  std::vector<std::string>
  split_list(const std::string &text, char separator = ',');
} // namespace wheelrail
