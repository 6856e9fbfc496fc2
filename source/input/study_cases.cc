#include <wheelrail/base/format_text.h>
#include <wheelrail/input/entries.h>
#include <wheelrail/input/scene_files.h>
#include <wheelrail/input/study_cases.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <iterator>
#include <map>

namespace wheelrail
{
  namespace
  {
    constexpr std::size_t most_cases = 10000;

    /// "Study/Axes = ...", the beginning of a fault.
    std::string
    axes_of(const Scene &scene)
    {
      return shown_text(entry_text(scene, "Study", "Axes")) + ": ";
    }

    /// A value as the listing writes it, so that 1 mm and 0.001 m are one.
    std::string
    listed(const StudyAxis &axis, const std::string &value)
    {
      Scene        scene;
      const Entry &entry = *find_entry(axis.section, axis.name);
      entry.set(scene, value);
      return entry.get(scene);
    }

    /// Fault of two cases, or two values, that are the same.
    std::string
    fault_of_twins(const Scene &scene)
    {
      std::map<std::vector<std::string>, std::size_t> first;
      const std::vector<StudyAxis>                   &axes = scene.study.axes;
      if (scene.study.combine == StudyCombination::pairs)
        {
          for (std::size_t i = 0; i < axes.front().values.size(); ++i)
            {
              std::vector<std::string> values;
              for (const StudyAxis &axis : axes)
                values.push_back(listed(axis, axis.values[i]));
              const auto [twin, is_new] = first.emplace(values, i);
              if (!is_new)
                return axes_of(scene) + "case " + std::to_string(i + 1) + " has the values of case " +
                       std::to_string(twin->second + 1) + "; keep one of them";
            }
          return "";
        }
      for (const StudyAxis &axis : axes)
        {
          first.clear();
          for (std::size_t i = 0; i < axis.values.size(); ++i)
            {
              const auto [twin, is_new] = first.emplace(std::vector{listed(axis, axis.values[i])}, i);
              if (!is_new)
                return axes_of(scene) + axis.path() + " takes the value " + shown_text(axis.values[i]) +
                       " twice, as " + shown_text(axis.values[twin->second]) + " and as " +
                       shown_text(axis.values[i]) + "; keep one of them";
            }
        }
      return "";
    }

    /// Small letters, digits and points of a text, with _ for what is between them.
    std::string
    name_part(const std::string &text)
    {
      std::string name;
      for (const char c : text)
        if (std::isalnum(static_cast<unsigned char>(c)) || c == '.' || c == '-')
          name += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
        else if (!name.empty() && name.back() != '_')
          name += '_';
      return name.substr(0, name.find_last_not_of('_') + 1);
    }

    /// The scene with one value of each axis.
    StudyCase
    make_case(const Scene &study, const std::vector<std::size_t> &picked, const std::string &program_version)
    {
      StudyCase one;
      one.scene       = study;
      one.scene.study = {};
      std::string words, names;
      for (std::size_t a = 0; a < study.study.axes.size(); ++a)
        {
          const StudyAxis &axis  = study.study.axes[a];
          const Entry     &entry = *find_entry(axis.section, axis.name);
          entry.set(one.scene, axis.values[picked[a]]);
          one.values.push_back(entry.get(one.scene));
          const std::string name = name_part(axis.name + " " + one.values.back());
          // rail and wheel that yield at the same stress
          if (names.find(name) == std::string::npos)
            {
              names += (names.empty() ? "" : "-") + name;
              words += (words.empty() ? "" : ", ") + axis.name + " " + one.values.back();
            }
        }
      one.name = names.substr(0, 80) + "-" + scene_digest(one.scene, program_version);
      if (one.scene.title == study.title)
        one.scene.title = shown_text((study.title.empty() ? "" : study.title + "; ") + words, 190);
      one.scene.folder = (std::filesystem::path(study.folder) / one.name).string();
      return one;
    }
  } // namespace


  std::vector<std::string>
  study_faults(const Scene &scene)
  {
    const std::vector<StudyAxis> &axes = scene.study.axes;
    if (axes.empty())
      return {};
    std::size_t cases = scene.study.combine == StudyCombination::pairs ? axes.front().values.size() : 1;
    for (const StudyAxis &axis : axes)
      if (scene.study.combine == StudyCombination::grid)
        cases = std::min(most_cases + 1, cases * axis.values.size());
      else if (axis.values.size() != cases)
        return {axes_of(scene) + axis.path() + " has " + std::to_string(axis.values.size()) + " values and " +
                axes.front().path() + " " + std::to_string(cases) +
                "; pairs need as many of each, or set Study/Combine = grid"};
    if (cases > most_cases)
      return {axes_of(scene) + "more than " + std::to_string(most_cases) +
              " cases; leave values out, or divide the study"};
    const std::string twins = fault_of_twins(scene);
    return twins.empty() ? std::vector<std::string>() : std::vector{twins};
  }


  std::vector<StudyCase>
  study_cases(const Scene &scene, const std::string &program_version)
  {
    const std::vector<StudyAxis> &axes = scene.study.axes;
    std::vector<StudyCase>        cases;
    if (axes.empty())
      return cases;
    const bool               pairs = scene.study.combine == StudyCombination::pairs;
    std::vector<std::size_t> picked(axes.size(), 0);
    while (true)
      {
        cases.push_back(make_case(scene, picked, program_version));
        std::size_t a = axes.size() - 1;
        if (pairs)
          {
            for (std::size_t &i : picked)
              ++i;
            if (picked[a] == axes[a].values.size())
              return cases;
            continue;
          }
        // as an odometer, the last axis fastest
        while (++picked[a] == axes[a].values.size())
          {
            picked[a] = 0;
            if (a-- == 0)
              return cases;
          }
      }
  }
} // namespace wheelrail
