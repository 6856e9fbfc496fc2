#include <wheelrail/base/split_list.h>

#include <algorithm>
#include <cstddef>

namespace wheelrail
{
  std::vector<std::string>
  split_list(const std::string &text, const char separator)
  {
    std::vector<std::string> parts;
    for (std::size_t begin = 0; begin <= text.size();)
      {
        const std::size_t end   = std::min(text.find(separator, begin), text.size());
        const std::size_t first = std::min(text.find_first_not_of(' ', begin), end);
        const std::size_t last  = text.find_last_not_of(' ', end == 0 ? 0 : end - 1);
        parts.push_back(first == end ? "" : text.substr(first, last + 1 - first));
        begin = end + 1;
      }
    return parts;
  }
} // namespace wheelrail
