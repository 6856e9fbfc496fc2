#include <wheelrail/base/errors.h>
#include <wheelrail/base/file_kind.h>
#include <wheelrail/base/read_file.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <sstream>

namespace wheelrail
{
  std::string
  read_whole_file(const std::string &path)
  {
    if (const std::string other = other_than_a_file(path); !other.empty())
      throw RunError("The file \"" + path + "\" is no ordinary file, but " + other + ".");
    errno = 0;
    std::ifstream      file(path, std::ios::binary);
    std::ostringstream text;
    if (file)
      text << file.rdbuf();
    if (!file || file.bad())
      throw RunError("The file \"" + path + "\" cannot be read: " + std::strerror(errno != 0 ? errno : EIO) +
                     ".");
    return text.str();
  }
} // namespace wheelrail
