#include <wheelrail/base/errors.h>
#include <wheelrail/base/format_text.h>
#include <wheelrail/base/read_file.h>
#include <wheelrail/input/entries.h>
#include <wheelrail/input/listing.h>
#include <wheelrail/input/motion_file.h>
#include <wheelrail/input/parameters.h>
#include <wheelrail/input/scene_files.h>
#include <wheelrail/profiles/profile_file.h>

#include <boost/uuid/name_generator_sha1.hpp>
#include <boost/uuid/uuid_io.hpp>

#include <filesystem>
#include <stdexcept>
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
    add_listed(const RunSettings &scene, std::vector<SceneFile> &files)
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
    const auto             add = [&](const std::string &entry,
                         const std::string &path,
                         const std::string &what,
                         const PathPlace   &value,
                         bool               in_run) {
      if (is_file_name(path))
        files.push_back({entry, path, what, value, in_run});
    };
    const auto member = [](std::string Scene::*value) {
      return [value](Scene &to) -> std::string & { return to.*value; };
    };
    add("Profiles/Wheel", scene.wheel_profile, "wheel", member(&Scene::wheel_profile), true);
    add("Profiles/Rail", scene.rail_profile, "rail", member(&Scene::rail_profile), true);
    add("Profiles/Second rail", scene.second_rail, "second_rail", member(&Scene::second_rail), true);
    add("Profiles/Wheel left",
        scene.left_wheel_profile,
        "wheel_left",
        member(&Scene::left_wheel_profile),
        false);
    add("Profiles/Rail left", scene.left_rail_profile, "rail_left", member(&Scene::left_rail_profile), false);
    add("Wear/Mix", scene.wear_plan.mix, "mix", nullptr, false);
    add("Wear/Grind to", scene.wear_plan.grind_to, "grind_to", nullptr, false);
    add("Wear/Turn to", scene.wear_plan.turn_to, "turn_to", nullptr, false);
    add("Wheelset/Motion", scene.motion, "motion", member(&Scene::motion), true);
    add("Half-space/Undeformed distance",
        scene.halfspace_distance,
        "distance",
        member(&Scene::halfspace_distance),
        false);
    for (int k = 0; k < most_irregularities; ++k)
      if (const IrregularityData &one = scene.irregularities[k]; one.in_file())
        add(
          "Irregularity " + std::to_string(k + 1) + "/File",
          one.file,
          "irregularity_" + std::to_string(k + 1),
          [k](Scene &to) -> std::string & { return to.irregularities[k].file; },
          true);
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
        std::string text = read_whole_file(file.path);
        if (is_slices_file(file.path))
          for (const std::string &slice : files_of_slices(file.path))
            text += read_whole_file(slice);
        return text;
      }
    catch (const std::runtime_error &) // the command that needs it tells
      {
        return "";
      }
  }


  namespace
  {
    std::string
    digest(const std::string &text)
    {
      return to_string(boost::uuids::name_generator_sha1(boost::uuids::ns::oid())(text)).substr(0, 8);
    }

    /// A file that is not there, or is empty, has none.
    std::string
    digest_if_any(const std::string &contents)
    {
      return contents.empty() ? "" : digest(contents);
    }

    /// Everything that the figures of a scene depend on.
    std::string
    identity(const Scene &scene, const std::string &program_version)
    {
      std::string                  text  = program_version + "\n";
      const std::vector<SceneFile> files = files_of(scene);
      for (const Entry &entry : entries())
        {
          const std::string path = entry.path();
          if (entry.section == "Study" || path == "Title" || path == "Output/Folder" ||
              path == "Output/Checkpoint interval")
            continue;
          const std::string value = entry.get(scene);
          text += path + " = " + value + "\n";
          // in the order of the entries, each file behind the one that names it
          for (const SceneFile &file : files)
            if (file.entry == path)
              text += digest_if_any(contents_of(file)) + "\n";
        }
      return text;
    }
  } // namespace


  std::string
  scene_digest(const Scene &scene, const std::string &program_version)
  {
    return digest(identity(scene, program_version));
  }
} // namespace wheelrail
