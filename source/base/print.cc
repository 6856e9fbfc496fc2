#include <wheelrail/base/print.h>

#include <algorithm>
#include <cerrno>
#include <iostream>

#include <poll.h>
#include <unistd.h>

namespace wheelrail
{
  namespace
  {
    /// Whether all went out. More than one call of write() only when a signal or a full pipe cuts the first
    /// off.
    bool
    write_line(const int file, const char *bytes, std::size_t left)
    {
      while (left > 0)
        {
          const ssize_t written = ::write(file, bytes, left);
          if (written > 0)
            {
              bytes += written;
              left -= static_cast<std::size_t>(written);
            }
          else if (written < 0 && errno == EAGAIN)
            {
              pollfd ready{file, POLLOUT, 0};
              ::poll(&ready, 1, -1);
            }
          else if (written == 0 || errno != EINTR)
            return false;
        }
      return true;
    }
  } // namespace


  void
  print(const int file, const std::string &text)
  {
    std::cout << std::flush;
    for (std::size_t begin = 0, end; begin < text.size(); begin = end)
      {
        end = std::min(text.find('\n', begin), text.size() - 1) + 1;
        if (!write_line(file, &text[begin], end - begin))
          return;
      }
  }
} // namespace wheelrail
