#include <wheelrail/base/choices.h>
#include <wheelrail/base/errors.h>
#include <wheelrail/base/hints.h>
#include <wheelrail/base/read_file.h>
#include <wheelrail/input/input_file.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <system_error>
#include <vector>

namespace wheelrail
{
  namespace
  {
    /// A parameter file in the same folder whose name resembles that of `path`, or nothing.
    std::string
    nearest_file(const std::filesystem::path &path)
    {
      std::error_code             code;
      const std::filesystem::path folder = path.has_parent_path() ? path.parent_path() : ".";
      std::vector<std::string>    names;
      for (const auto &file : std::filesystem::directory_iterator(folder, code))
        if (file.path().extension() == ".prm")
          names.push_back(file.path().filename().string());
      std::sort(names.begin(), names.end());
      const std::string nearest = nearest_choice(path.filename().string(), names);
      return nearest.empty() ? "" : (path.parent_path() / nearest).string();
    }
  } // namespace

  std::string
  read_input_file(const std::string &path)
  {
    namespace fs = std::filesystem;
    std::error_code code;
    const bool      there = fs::exists(path, code);
    if (code == std::errc::too_many_symbolic_link_levels)
      throw InputError(path + ": a symbolic link that leads back to itself; correct it with ln -sf");
    if (!there && fs::is_symlink(path, code))
      throw InputError(path + ": a symbolic link to " + fs::read_symlink(path, code).string() +
                       ", which is not there; correct it with ln -sf");
    if (!there)
      {
        const std::string nearest = nearest_file(path);
        throw InputError(path + ": no such file" + (nearest.empty() ? "" : "; the nearest is " + nearest));
      }
    if (const std::string other = other_than_a_file(path); !other.empty())
      throw InputError(path + ": " + other + "; a parameter file (.prm) is needed");
    std::ifstream file(path, std::ios::binary);
    if (!file)
      throw InputError(path + ": cannot be read; check its permissions");

    constexpr std::size_t largest = 1 << 20;
    std::string           text;
    for (char c; text.size() <= largest && file.get(c);)
      text += c;
    if (text.size() > largest)
      throw InputError(path + ": larger than 1 MiB; this is no parameter file");
    const auto is_binary = [](const char c) {
      return static_cast<unsigned char>(c) < 32 && c != '\n' && c != '\r' && c != '\t';
    };
    if (std::any_of(text.begin(), text.end(), is_binary))
      throw InputError(path + ": not a text file; a parameter file (.prm) is needed");
    if (text.find_first_not_of("\n \t\r") == std::string::npos)
      throw InputError(path + ": empty; \"" + own_call() + " parameters\" prints a complete parameter file");
    return text;
  }
} // namespace wheelrail
