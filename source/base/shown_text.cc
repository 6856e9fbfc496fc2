#include <wheelrail/base/shown_text.h>

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
} // namespace wheelrail
