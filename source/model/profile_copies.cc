#include <wheelrail/base/errors.h>
#include <wheelrail/geometry/profile_file.h>
#include <wheelrail/model/profile_copies.h>
#include <wheelrail/output/replace_file.h>

#include <filesystem>
#include <system_error>

namespace wheelrail
{
  namespace
  {
    namespace fs = std::filesystem;

    fs::path
    copy_of(const std::string &file, const char *body, const std::string &folder)
    {
      return fs::path(folder) / "profiles" / (body + ("_" + fs::path(file).filename().string()));
    }
  } // namespace


  void
  keep_profiles(const Scene &scene, const std::string &folder)
  {
    const auto keep = [&](const std::string &file, const char *body) {
      if (!is_file_name(file))
        return;
      const fs::path  copy = copy_of(file, body, folder);
      std::error_code ignored; // a folder that cannot be made shows when the file is written
      fs::create_directories(copy.parent_path(), ignored);
      replace_file(copy.string(), read_whole_file(file));
    };
    keep(scene.wheel_profile, "wheel");
    keep(scene.rail_profile, "rail");
    keep(scene.motion, "motion");
  }


  void
  use_kept_profiles(Scene &scene, const std::string &folder)
  {
    const auto use = [&](std::string &file, const char *body) {
      const fs::path copy = copy_of(file, body, folder);
      if (is_file_name(file) && fs::exists(copy))
        file = copy.string();
    };
    use(scene.wheel_profile, "wheel");
    use(scene.rail_profile, "rail");
    use(scene.motion, "motion");
  }
} // namespace wheelrail
