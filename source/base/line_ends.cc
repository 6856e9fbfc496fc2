#include <wheelrail/base/line_ends.h>

namespace wheelrail
{
  std::string
  with_line_feeds(const std::string &text)
  {
    std::string result;
    result.reserve(text.size());
    for (std::size_t i = 0; i < text.size(); ++i)
      if (text[i] != '\r')
        result += text[i];
      else if (i + 1 == text.size() || text[i + 1] != '\n')
        result += '\n';
    return result;
  }
} // namespace wheelrail
