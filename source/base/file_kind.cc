#include <wheelrail/base/file_kind.h>

#include <filesystem>
#include <system_error>

namespace wheelrail
{
  std::string
  other_than_a_file(const std::string &path)
  {
    std::error_code ignored; // what cannot be looked at cannot be opened, which the reader tells
    switch (std::filesystem::status(path, ignored).type())
      {
        case std::filesystem::file_type::directory:
          return "a folder";
        case std::filesystem::file_type::fifo:
          return "a pipe";
        case std::filesystem::file_type::socket:
          return "a socket";
        case std::filesystem::file_type::block:
        case std::filesystem::file_type::character:
          return "a device";
        default:
          return "";
      }
  }
} // namespace wheelrail
