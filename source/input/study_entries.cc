#include <wheelrail/base/errors.h>
#include <wheelrail/base/format_text.h>
#include <wheelrail/input/entries.h>
#include <wheelrail/input/section_entries.h>

#include <boost/algorithm/string/trim.hpp>

#include <string>
#include <vector>

namespace wheelrail
{
  namespace
  {
    /// The entry of an axis. Throws InputError when there is none, or when it cannot vary.
    const Entry &
    entry_of_axis(const std::string &section, const std::string &name)
    {
      if (!section_exists(section))
        throw InputError(unknown_section(section));
      const Entry *const entry = find_entry(section, name);
      if (entry == nullptr)
        throw InputError(unknown_entry(section, name));
      if (section == "Study" || entry->path() == "Output/Folder")
        throw InputError("cannot vary within a study; every case gets a folder of its own");
      return *entry;
    }

    /// "Section/Entry: value, value".
    StudyAxis
    parse_axis(const std::string &text)
    {
      const std::size_t colon = text.find(':');
      if (colon == std::string::npos)
        throw InputError("\"" + shown_text(text) +
                         "\" is no axis; write \"Section/Entry: value, value\", and a semicolon between two "
                         "axes");
      const std::string path  = boost::trim_copy(text.substr(0, colon));
      const std::size_t slash = path.find('/');
      StudyAxis         axis;
      axis.section = slash == std::string::npos ? "" : boost::trim_copy(path.substr(0, slash));
      axis.name    = slash == std::string::npos ? path : boost::trim_copy(path.substr(slash + 1));
      axis.values  = split_list(text.substr(colon + 1), ',');
      std::string at;
      try
        {
          const Entry &entry = entry_of_axis(axis.section, axis.name);
          for (const std::string &value : axis.values)
            {
              at = ": \"" + shown_text(value) + "\"";
              Scene trial;
              entry.set(trial, value);
            }
        }
      catch (const InputError &error)
        {
          throw InputError(shown_text(path) + at + ": " + error.what());
        }
      return axis;
    }

    std::vector<StudyAxis>
    parse_axes(const std::string &text)
    {
      std::vector<StudyAxis> axes;
      for (const std::string &part : split_list(text, ';'))
        {
          if (part.empty()) // a semicolon at the end, or no axes
            continue;
          axes.push_back(parse_axis(part));
          for (std::size_t i = 0; i + 1 < axes.size(); ++i)
            if (axes[i].path() == axes.back().path())
              throw InputError(axes[i].path() + " is two axes; put their values into one");
        }
      return axes;
    }

    std::string
    axes_text(const std::vector<StudyAxis> &axes)
    {
      std::string text;
      for (const StudyAxis &axis : axes)
        {
          text += (text.empty() ? "" : "; ") + axis.path() + ":";
          for (std::size_t i = 0; i < axis.values.size(); ++i)
            text += (i == 0 ? " " : ", ") + axis.values[i];
        }
      return text;
    }
  } // namespace


  std::vector<Entry>
  study_entries()
  {
    EntryList list("Study");
    list.add(
      "Axes",
      "What varies from case to case, for the command study: entries and their values, such as "
      "Contact/Friction coefficient: 0.1, 0.2; Wheelset/Lateral shift: -1 mm, 0 mm.",
      "axes \"Section/Entry: value, value\" with semicolons between them, or nothing",
      [](Scene &scene, const std::string &text) { scene.study.axes = parse_axes(text); },
      [](const Scene &scene) { return axes_text(scene.study.axes); });
    list.choice<StudyCombination>(
      "Combine",
      {{"grid", StudyCombination::grid}, {"pairs", StudyCombination::pairs}},
      field(&Scene::study, &Study::combine),
      "Cases of several axes. grid: every value with every value of the others; pairs: the first values "
      "together, the second ones, ...");
    list.choice<StudyComputation>(
      "Compute",
      {{"run", StudyComputation::run},
       {"halfspace", StudyComputation::halfspace},
       {"both", StudyComputation::both}},
      field(&Scene::study, &Study::compute),
      "run: finite elements; halfspace: half-spaces under the scene's own load; both: finite elements, and "
      "half-spaces under the load and in the position of each run.");
    return list.entries;
  }
} // namespace wheelrail
