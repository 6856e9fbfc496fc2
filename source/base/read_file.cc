#include <wheelrail/base/errors.h>
#include <wheelrail/base/read_file.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <system_error>

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


  std::string
  shared_file(const std::string &name)
  {
    namespace fs = std::filesystem;
    std::error_code ignored; // without /proc the folder is empty, and the error below says so
    const fs::path  folder = fs::read_symlink("/proc/self/exe", ignored).parent_path();
    // first as in the build folder, then as installed (bin/ and share/) and for programs of tests
    const fs::path beside = folder / "share/wheelrail" / name,
                   above  = folder.parent_path() / "share/wheelrail" / name;
    for (const fs::path &path : {beside, above})
      if (fs::exists(path, ignored))
        return path.string();
    throw RunError("a file of the program is missing: neither " + beside.string() + " nor " + above.string() +
                   " is there; build or install the program again");
  }
} // namespace wheelrail
