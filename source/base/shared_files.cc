#include <wheelrail/base/errors.h>
#include <wheelrail/base/shared_files.h>

#include <filesystem>

namespace wheelrail
{
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
