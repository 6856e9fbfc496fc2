#include <wheelrail/base/errors.h>
#include <wheelrail/geometry/profiles.h>
#include <wheelrail/input/entry_kinds.h>
#include <wheelrail/input/section_entries.h>

#include <algorithm>
#include <map>
#include <string>
#include <vector>

namespace wheelrail
{
  namespace
  {
    void
    add_file_options(EntryList         &list,
                     const std::string &body,
                     ProfileFileOptions Scene::*part,
                     const std::string         &mirror,
                     const std::string         &upright)
    {
      const Words<ProfileMirror> turned = {
        {"auto", ProfileMirror::automatic}, {"yes", ProfileMirror::yes}, {"no", ProfileMirror::no}};
      list.choice<ProfileMirror>(body + " mirror", turned, field(part, &ProfileFileOptions::mirror), mirror);
      list.choice<ProfileMirror>(body + " upside down",
                                 turned,
                                 field(part, &ProfileFileOptions::turn),
                                 "Vertical coordinate turned over; auto: " + upright + ".");
      list.choice<ProfileUnit>(body + " unit",
                               {{"auto", ProfileUnit::automatic},
                                {"mm", ProfileUnit::millimetre},
                                {"m", ProfileUnit::metre},
                                {"inch", ProfileUnit::inch}},
                               field(part, &ProfileFileOptions::unit),
                               "auto: as the file states, else mm or m by size.");
    }

    void
    add_body(EntryList &list)
    {
      Words<std::string> choices{{"auto", "auto"}};
      for (const std::string &name : standard_rails())
        choices.push_back({name, name});
      list.choice<std::string>(
        "Rail body",
        choices,
        field(&Scene::rail_body),
        "Standard rail below a head from a file; auto: the one whose head is as wide.");
    }

    /// One value for both files.
    void
    add_smoothing(EntryList &list)
    {
      Entry &entry =
        list.number({"Smoothing", "mm", "0 mm", "1 mm"},
                    field(&Scene::rail_file, &ProfileFileOptions::noise),
                    "Noise (standard deviation) smoothed out of profile files; auto: as found in the "
                    "points; 0 mm: every point is kept.",
                    {{"auto", -1}});
      entry.set = [set = entry.set](Scene &scene, const std::string &text) {
        set(scene, text);
        scene.wheel_file.noise = scene.rail_file.noise;
      };
    }

    /// Rails by the names that they had before EN 13674-1 are answered by those of today.
    void
    refuse_former_rails(Entry &entry)
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
    }

    /// Of the other wheel of a whole wheelset.
    Entry &
    add_left(EntryList                      &list,
             const std::string              &name,
             const std::vector<std::string> &standard,
             const std::string              &file,
             const Field<std::string>       &place)
    {
      std::vector<std::string> names{"as right"};
      names.insert(names.end(), standard.begin(), standard.end());
      return list.name_or_file(name + " left",
                               names,
                               file,
                               place,
                               "Left-hand, with Wheelset/Wheels = both; a file is read as that of " + name +
                                 ".");
    }
  } // namespace


  std::vector<Entry>
  profiles_entries()
  {
    EntryList         list("Profiles");
    const std::string wheel_file = "a profile file (with its ending, such as worn.prw)",
                      rail_file  = "a profile file (with its ending, such as worn.prr)";
    list.name_or_file("Wheel",
                      standard_wheels(),
                      wheel_file,
                      field(&Scene::wheel_profile),
                      "Wheel profile (S1002: EN 13715; cone: straight tread with the flange of S1002); a "
                      "relative path of a file starts where the command is given.");
    add_left(list, "Wheel", standard_wheels(), wheel_file, field(&Scene::left_wheel_profile));
    add_file_options(list,
                     "Wheel",
                     &Scene::wheel_file,
                     "Lateral coordinate turned to the other side; auto: by the flange.",
                     "the flange hangs down");
    list.choice<WheelOrigin>(
      "Wheel origin",
      {{"auto", WheelOrigin::automatic},
       {"running circle", WheelOrigin::running_circle},
       {"flange back", WheelOrigin::flange_back}},
      field(&Scene::wheel_origin),
      "Lateral origin of the file; auto: from flange back, or flange tip where that was not measured.");
    refuse_former_rails(list.name_or_file("Rail",
                                          standard_rails(),
                                          rail_file,
                                          field(&Scene::rail_profile),
                                          "Rail profile (54E1, 60E1: EN 13674-1), or slices (.slcs)."));
    refuse_former_rails(
      add_left(list, "Rail", standard_rails(), rail_file, field(&Scene::left_rail_profile)));
    add_file_options(
      list,
      "Rail",
      &Scene::rail_file,
      "Lateral coordinate turned to the other side; auto: of MiniProf files (gauge side on the right) alone.",
      "the crown lies on top");
    list.choice<bool>("Rail origin",
                      {{"auto", false}, {"running circle", true}},
                      field(&Scene::rail_file, &ProfileFileOptions::placed),
                      "Of the rail file; auto: by sides and gauge; running circle: below it.");
    add_body(list);
    add_smoothing(list);
    list.name_or_file("Second rail",
                      {"none"},
                      "a file of slices (.slcs)",
                      field(&Scene::second_rail),
                      "Slices under the same wheel: a nose, or the rail behind a gap.");
    list.number({"Rail place", "mm", "-1000 m", "1000 m"},
                field(&Scene::rail_place),
                "Along slices, where the path begins.");
    return list.entries;
  }
} // namespace wheelrail
