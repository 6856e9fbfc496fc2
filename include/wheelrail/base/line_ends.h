#pragma once

#include <string>

namespace wheelrail
{
  /// The text with '\n' at the end of every line. Files end their lines by LF, by CR LF (Windows) or by CR
  /// alone (old Macintosh programs and some measuring devices); read by lines of LF, the last kind would be
  /// one line only, and all of it a comment after its first mark.
  std::string
  with_line_feeds(const std::string &text);
} // namespace wheelrail
