#include <wheelrail/base/errors.h>
#include <wheelrail/base/read_file.h>
#include <wheelrail/input/scene_files.h>
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
    copy_of(const SceneFile &file, const std::string &folder)
    {
      return fs::path(folder) / "profiles" / (file.what + "_" + fs::path(file.path).filename().string());
    }
  } // namespace


  void
  keep_profiles(const Scene &scene, const std::string &folder)
  {
    for (const SceneFile &file : files_of(scene))
      {
        if (!file.in_run)
          continue;
        const fs::path  copy = copy_of(file, folder);
        std::error_code ignored; // a folder that cannot be made shows when the file is written
        fs::create_directories(copy.parent_path(), ignored);
        replace_file(copy.string(), read_whole_file(file.path));
      }
  }


  void
  use_kept_profiles(Scene &scene, const std::string &folder)
  {
    for (const SceneFile &file : files_of(scene))
      if (const fs::path copy = copy_of(file, folder); file.in_run && fs::exists(copy))
        file.value(scene) = copy.string();
  }


  std::string
  changed_since_start(const Scene &scene, const std::string &folder)
  {
    for (const SceneFile &file : files_of(scene))
      if (const fs::path copy = copy_of(file, folder);
          file.in_run && fs::exists(copy) && read_whole_file(copy.string()) != read_whole_file(file.path))
        return file.entry + " = " + file.path +
               ": this file has changed since the run began, which has kept it as " + copy.string() +
               "; set it back to that, or start anew in another Output/Folder";
    return "";
  }
} // namespace wheelrail
