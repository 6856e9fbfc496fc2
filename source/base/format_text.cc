#include <wheelrail/base/format_text.h>

#include <algorithm>
#include <cstddef>

namespace wheelrail
{
  std::string
  shown_text(const std::string &text, const std::size_t most)
  {
    std::string shown = text;
    if (shown.size() > most)
      {
        // the bytes after the first of a letter are 10xxxxxx in binary
        std::size_t end = most;
        while (end > 0 && (static_cast<unsigned char>(shown[end]) & 0xC0) == 0x80)
          --end;
        shown = shown.substr(0, end) + "...";
      }
    for (char &c : shown)
      if (static_cast<unsigned char>(c) < 32 || c == 127)
        c = '?';
    return shown;
  }


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
