#pragma once

#include <string>

namespace wheelrail
{
  /// A text of the user as a message repeats it: control characters become "?", and what is longer
  /// than `most` bytes is cut and ends with "...". Letters of UTF-8 stay whole.
  std::string
  shown_text(const std::string &text, std::size_t most = 100);
} // namespace wheelrail
