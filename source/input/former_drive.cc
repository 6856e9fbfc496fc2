#include <wheelrail/base/errors.h>
#include <wheelrail/base/format_text.h>
#include <wheelrail/input/former_drive.h>
#include <wheelrail/input/motion_file.h>

#include <algorithm>
#include <vector>

namespace wheelrail
{
  namespace
  {
    const std::string entry = "Wheelset/Traction coefficient";

    /// Whether the text, --set or an axis of the study has the entry, or it does not matter.
    bool
    says_it(const SceneInput &input)
    {
      const auto &axes = input.scene.study.axes;
      return input.scene.drive == Drive::rate || input.origin.count(entry) > 0 ||
             std::any_of(
               axes.begin(), axes.end(), [](const StudyAxis &axis) { return axis.path() == entry; });
    }

    /// The files that do not say it: the scene's own, or those of its passage list.
    std::vector<std::string>
    silent_files(const SceneInput &input)
    {
      const Scene &scene = input.scene;
      if (is_list_of_scenes(scene.passage_list))
        {
          std::vector<std::string> silent;
          for (const std::string &name : split_list(scene.passage_list, ','))
            if (!says_it(read_scene(name, {})) &&
                std::find(silent.begin(), silent.end(), name) == silent.end())
              silent.push_back(name);
          return silent;
        }
      const bool in_table = scene.motion != "none"         ? has_drive(read_motion_file(scene.motion))
                            : scene.passage_list != "none" ? has_drive(read_passage_list(scene.passage_list))
                                                           : false;
      return in_table || says_it(input) ? std::vector<std::string>() : std::vector<std::string>{input.name};
    }
  } // namespace


  std::string
  former_drive_note(const SceneInput &input)
  {
    std::string names;
    try
      {
        for (const std::string &name : silent_files(input))
          names += (names.empty() ? "" : ", ") + name;
      }
    catch (const InputError &)
      {
        return "";
      }
    if (names.empty())
      return "";
    return names + ": " + entry +
           " is not set: the wheel rolls freely, since its default is 0 now and was 0.25 in earlier "
           "versions; "
           "write \"set Traction coefficient = 0.25\" in subsection Wheelset for what they did, or 0 to be "
           "rid of "
           "this note";
  }
} // namespace wheelrail
