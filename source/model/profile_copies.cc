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

    /// Of slices a text: with all that they name.
    fs::path
    copy_of(const SceneFile &file, const std::string &folder)
    {
      return fs::path(folder) / "profiles" /
             (file.what + "_" + fs::path(file.path).filename().string() +
              (is_slices_file(file.path) ? ".txt" : ""));
    }

    std::string
    kept(const SceneFile &file)
    {
      return is_slices_file(file.path) ? contents_of(file) : read_whole_file(file.path);
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
        replace_file(copy.string(), kept(file));
      }
  }


  void
  use_kept_profiles(Scene &scene, const std::string &folder)
  {
    for (const SceneFile &file : files_of(scene))
      if (const fs::path copy = copy_of(file, folder);
          file.in_run && !is_slices_file(file.path) && fs::exists(copy))
        file.value(scene) = copy.string();
  }


  std::string
  changed_since_start(const Scene &scene, const std::string &folder)
  {
    for (const SceneFile &file : files_of(scene))
      if (const fs::path copy = copy_of(file, folder);
          file.in_run && fs::exists(copy) && read_whole_file(copy.string()) != kept(file))
        return file.entry + " = " + file.path +
               (is_slices_file(file.path) ? ": this file or one of its slices has changed"
                                          : ": this file has changed") +
               " since the run began, which has kept it as " + copy.string() +
               "; set it back to that, or start anew in another Output/Folder";
    return "";
  }
} // namespace wheelrail
