#include <wheelrail/base/errors.h>
#include <wheelrail/geometry/profiles.h>
#include <wheelrail/input/entry_kinds.h>
#include <wheelrail/input/section_entries.h>

#include <algorithm>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace wheelrail
{
  namespace
  {
    Entry
    mirror_entry(const std::string &name, const std::string &meaning, ProfileFileOptions Scene::*part)
    {
      return choice_entry<ProfileMirror>(
        {"Profiles", name, meaning},
        {{"auto", ProfileMirror::automatic}, {"yes", ProfileMirror::yes}, {"no", ProfileMirror::no}},
        field(part, &ProfileFileOptions::mirror));
    }

    Entry
    unit_entry(const std::string &name, const std::string &meaning, ProfileFileOptions Scene::*part)
    {
      return choice_entry<ProfileUnit>({"Profiles", name, meaning},
                                       {{"auto", ProfileUnit::automatic},
                                        {"mm", ProfileUnit::millimetre},
                                        {"m", ProfileUnit::metre},
                                        {"inch", ProfileUnit::inch}},
                                       field(part, &ProfileFileOptions::unit));
    }

    Entry
    body_entry()
    {
      std::vector<std::pair<std::string, std::string>> choices{{"auto", "auto"}};
      for (const std::string &name : standard_rails())
        choices.push_back({name, name});
      return choice_entry<std::string>(
        {"Profiles",
         "Rail body",
         "Standard rail below a head that is read from a file; auto: the one whose head "
         "is as wide."},
        choices,
        field(&Scene::rail_body));
    }

    /// One value for both files.
    Entry
    smoothing_entry()
    {
      const auto rail  = field(&Scene::rail_file, &ProfileFileOptions::noise);
      Entry      entry = with_word(
        length_entry({"Profiles",
                           "Smoothing",
                           "Measurement noise (standard deviation) that is smoothed out of profile files; "
                                "auto: as found in the points, some 10 um are usual; 0 mm: every point is kept."},
                     "mm",
                     Bounds::between("0 mm", "1 mm"),
                     rail),
        "auto",
        -1,
        rail);
      entry.set = [set = entry.set](Scene &scene, const std::string &text) {
        set(scene, text);
        scene.wheel_file.noise = scene.rail_file.noise;
      };
      return entry;
    }
    /// Rails by the names that they had before EN 13674-1 are answered by those of today.
    Entry
    with_other_rails(Entry entry)
    {
      entry.set = [set = entry.set](Scene &scene, const std::string &text) {
        static const std::map<std::string, std::string> former = {{"UIC60", "60E1"}, {"UIC54", "54E1"}};
        std::string                                     name   = text;
        name.erase(std::remove_if(name.begin(), name.end(), [](const char c) { return c == ' '; }),
                   name.end());
        if (const auto found = former.find(name); found != former.end())
          throw InputError("the former name of " + found->second + " (EN 13674-1); write " + found->second);
        set(scene, text);
      };
      return entry;
    }

    /// Of the other wheel of a whole wheelset.
    Entry
    left_entry(const std::string              &name,
               const std::vector<std::string> &standard,
               const std::string              &file,
               const Field<std::string>       &place)
    {
      std::vector<std::string> names{"as right"};
      names.insert(names.end(), standard.begin(), standard.end());
      return name_or_file_entry(
        {"Profiles",
         name + " left",
         "Of the left-hand side, with Wheelset/Wheels = both; a file is read as that of " + name + "."},
        names,
        file,
        place);
    }
  } // namespace

  std::vector<Entry>
  profiles_entries()
  {
    const std::string wheel_file = "a profile file (with its ending, such as worn.prw)",
                      rail_file  = "a profile file (with its ending, such as worn.prr)";
    const std::string unit = "Unit of the profile file; auto: as the file states, else mm or m by its size.";
    return {
      name_or_file_entry({"Profiles",
                          "Wheel",
                          "Wheel profile (S1002: EN 13715; cone: straight tread with the flange of S1002); a "
                          "relative path of a file counts from where the "
                          "command is given."},
                         standard_wheels(),
                         wheel_file,
                         field(&Scene::wheel_profile)),
      left_entry("Wheel", standard_wheels(), wheel_file, field(&Scene::left_wheel_profile)),
      mirror_entry(
        "Wheel mirror",
        "Whether the lateral coordinate of the wheel file is turned to the other side; auto: by the "
        "side of the flange.",
        &Scene::wheel_file),
      unit_entry("Wheel unit", unit, &Scene::wheel_file),
      choice_entry<WheelOrigin>(
        {"Profiles",
         "Wheel origin",
         "Lateral origin of the wheel file; auto: found from the flange back, or from the "
         "flange tip where the back was not measured."},
        {{"auto", WheelOrigin::automatic},
         {"running circle", WheelOrigin::running_circle},
         {"flange back", WheelOrigin::flange_back}},
        field(&Scene::wheel_origin)),
      with_other_rails(name_or_file_entry(
        {"Profiles",
         "Rail",
         "Rail profile (54E1, 60E1: EN 13674-1); a relative path of a file counts from where the "
         "command is given."},
        standard_rails(),
        rail_file,
        field(&Scene::rail_profile))),
      with_other_rails(left_entry("Rail", standard_rails(), rail_file, field(&Scene::left_rail_profile))),
      mirror_entry(
        "Rail mirror",
        "Whether the lateral coordinate of the rail file is turned to the other side; auto: MiniProf "
        "files are (gauge side on the right), others are not (field side on the right).",
        &Scene::rail_file),
      unit_entry("Rail unit", unit, &Scene::rail_file),
      body_entry(),
      smoothing_entry()};
  }
} // namespace wheelrail
