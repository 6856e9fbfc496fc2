#include <wheelrail/base/errors.h>
#include <wheelrail/base/read_file.h>
#include <wheelrail/base/split_list.h>
#include <wheelrail/input/listing.h>
#include <wheelrail/input/motion_file.h>
#include <wheelrail/input/parameters.h>
#include <wheelrail/input/scene_files.h>
#include <wheelrail/profiles/profile_file.h>

#include <filesystem>
#include <utility>

namespace wheelrail
{
  namespace
  {
    bool
    is_scene(const std::string &path)
    {
      return std::filesystem::path(path).extension() == ".prm";
    }

    /// The scenes of a list, each with what it names itself: a scene of a list has no list.
    void
    add_listed(const Scene &scene, std::vector<SceneFile> &files)
    {
      if (!is_file_name(scene.passage_list))
        return;
      const std::string entry = "Run/Passage list";
      for (const std::string &path : is_list_of_scenes(scene.passage_list)
                                       ? split_list(scene.passage_list, ',')
                                       : std::vector<std::string>{scene.passage_list})
        {
          files.push_back({entry, path, "list", nullptr, false});
          if (!is_scene(path))
            continue;
          try
            {
              Scene listed        = read_scene(path, {}).scene;
              listed.passage_list = "none";
              for (SceneFile &file : files_of(listed))
                files.push_back({entry, std::move(file.path), "list", nullptr, false});
            }
          catch (const InputError &)
            {
              // a scene that cannot be read names nothing; the command that needs it tells
            }
        }
    }
  } // namespace


  std::vector<SceneFile>
  files_of(const Scene &scene)
  {
    std::vector<SceneFile> files;
    const auto             add = [&](const char        *entry,
                         const std::string &path,
                         const char        *what,
                         std::string Scene::*value,
                         bool                in_run) {
      if (is_file_name(path))
        files.push_back({entry, path, what, value, in_run});
    };
    add("Profiles/Wheel", scene.wheel_profile, "wheel", &Scene::wheel_profile, true);
    add("Profiles/Rail", scene.rail_profile, "rail", &Scene::rail_profile, true);
    add("Profiles/Wheel left", scene.left_wheel_profile, "wheel_left", &Scene::left_wheel_profile, false);
    add("Profiles/Rail left", scene.left_rail_profile, "rail_left", &Scene::left_rail_profile, false);
    add("Wheelset/Motion", scene.motion, "motion", &Scene::motion, true);
    add("Half-space/Undeformed distance",
        scene.halfspace_distance,
        "distance",
        &Scene::halfspace_distance,
        false);
    add("Material test/File", scene.material_test.file, "material_test", nullptr, false);
    add_listed(scene, files);
    if (scene.rail_from != "new")
      files.push_back({"Run/Rail", scene.rail_from + "/rail.h5", "rail_state", nullptr, false});
    return files;
  }


  std::string
  contents_of(const SceneFile &file)
  {
    if (is_scene(file.path))
      try
        {
          return print_parameters(read_scene(file.path, {}).scene);
        }
      catch (const InputError &)
        {
          // its bytes, then
        }
    try
      {
        return read_whole_file(file.path);
      }
    catch (const RunError &)
      {
        return "";
      }
  }
} // namespace wheelrail
