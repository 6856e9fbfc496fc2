#include <wheelrail/base/choices.h>
#include <wheelrail/base/errors.h>
#include <wheelrail/base/format_text.h>
#include <wheelrail/base/quantity.h>
#include <wheelrail/input/entries.h>
#include <wheelrail/input/section_entries.h>

#include <boost/algorithm/string/case_conv.hpp>

#include <algorithm>
#include <utility>

namespace wheelrail
{
  namespace
  {
    /// A text that fits on a line and into a page's head.
    std::vector<Entry>
    title_entry()
    {
      EntryList list("");
      Entry    &entry = list.text("Title", field(&Scene::title), "Name of the scene in the output.");
      entry.set       = [set = entry.set](Scene &scene, const std::string &text) {
        // bytes of UTF-8 that continue a character do not count
        const auto n =
          std::count_if(text.begin(), text.end(), [](const char c) { return (c & 0xc0) != 0x80; });
        if (n > 200)
          throw InputError("too long, " + std::to_string(n) + " characters; at most 200 are accepted");
        set(scene, text);
      };
      return list.entries;
    }

    std::string
    join(const std::vector<std::string> &parts, const std::string &between)
    {
      std::string text;
      for (const std::string &part : parts)
        text += (text.empty() ? "" : between) + part;
      return text;
    }

    /// Of an entry that is called an axle load: half of its value, given as a force or as a mass, as a force;
    /// empty of all others.
    std::string
    half_of_axle_load(const std::string &name, const std::string &value)
    {
      const std::string small = boost::to_lower_copy(name);
      const auto        has   = [&](const char *word) { return small.find(word) != std::string::npos; };
      if (!has("axle") || !(has("load") || has("weight")))
        return "";
      for (const auto &[dimension, factor] :
           {std::pair(Dimension::force, 1.), std::pair(Dimension::mass, Scene().gravity)})
        try
          {
            return text("%.5g kN", 0.5e-3 * factor * parse_quantity(value, dimension));
          }
        catch (const InputError &)
          {
            // of another dimension, or no number
          }
      return "... kN";
    }
  } // namespace

  const std::vector<Entry> &
  entries()
  {
    static const std::vector<Entry> table = [] {
      std::vector<Entry> list;
      for (const std::vector<Entry> &section : {title_entry(),
                                                profiles_entries(),
                                                track_entries(),
                                                wheelset_entries(),
                                                contact_entries(),
                                                material_entries("Rail material", &Scene::rail_material),
                                                material_entries("Wheel material", &Scene::wheel_material),
                                                mesh_entries(),
                                                run_entries(),
                                                output_entries(),
                                                halfspace_entries(),
                                                irregularity_entries(),
                                                wear_entries(),
                                                material_test_entries(),
                                                study_entries()})
        list.insert(list.end(), section.begin(), section.end());
      for (Entry &entry : list)
        entry.default_text = entry.get(Scene());
      return list;
    }();
    return table;
  }

  const Entry *
  find_entry(const std::string &section, const std::string &name)
  {
    for (const Entry &entry : entries())
      if (entry.section == section && entry.name == name)
        return &entry;
    return nullptr;
  }

  std::vector<std::string>
  section_names()
  {
    std::vector<std::string> names;
    for (const Entry &entry : entries())
      if (!entry.section.empty() && std::find(names.begin(), names.end(), entry.section) == names.end())
        names.push_back(entry.section);
    return names;
  }

  bool
  section_exists(const std::string &section)
  {
    const std::vector<std::string> names = section_names();
    return section.empty() || std::find(names.begin(), names.end(), section) != names.end();
  }

  std::string
  unknown_section(const std::string &section)
  {
    const std::vector<std::string> names   = section_names();
    const std::string              nearest = nearest_choice(section, names);
    if (section.rfind("Irregularity ", 0) == 0)
      return "no such subsection; there are Irregularity 1 to " + std::to_string(most_irregularities) +
             ", and a file may hold more (Kind = file)";
    if (!nearest.empty())
      return "no such subsection; the nearest is " + nearest;
    return "no such subsection; there are " + join(names, ", ");
  }

  std::string
  unknown_entry(const std::string &section, const std::string &name, const std::string &value)
  {
    if (const std::string load = half_of_axle_load(name, value); !load.empty())
      return "no such entry; a wheel carries half of it: write \"set Wheel load = " + load +
             "\" in subsection Wheelset";
    if (section == "Run" && (name == "Passage jump" || name == "Jump error"))
      return "no such entry; all passages are computed: leave it out";
    const std::vector<std::string> nearest = nearest_entries(section, name);
    if (!nearest.empty())
      return "no such entry; the nearest " + std::string(nearest.size() == 1 ? "is " : "are ") +
             join(nearest, ", ");
    std::vector<std::string> names;
    for (const Entry &entry : entries())
      if (entry.section == section)
        names.push_back(entry.name);
    return "no such entry; " + (section.empty() ? std::string("outside the subsections") : section) +
           " has " + join(names, ", ");
  }

  std::vector<std::string>
  nearest_entries(const std::string &section, const std::string &name)
  {
    struct Candidate
    {
      unsigned int distance;
      bool         elsewhere;
      std::string  path;
    };
    std::vector<Candidate> candidates;
    if (name.size() > 200) // resembles nothing
      return {};
    const bool known_section = !section.empty() && section_exists(section);
    for (const Entry &entry : entries())
      {
        const unsigned int distance  = edit_distance(entry.name, name);
        const bool         elsewhere = entry.section != section;
        const unsigned int farther   = elsewhere && known_section ? 3 : 0;
        // a short name in its right section is a word of the user's own, no slip of an entry elsewhere
        const std::size_t most =
          elsewhere && known_section ? name.size() / 6 : std::max<std::size_t>(2, name.size() / 3);
        const bool begins_alike = !elsewhere && distance <= 3 && entry.name.compare(0, 3, name, 0, 3) == 0;
        if (distance <= most || begins_alike)
          candidates.push_back({distance + farther, elsewhere, entry.path()});
      }
    std::stable_sort(candidates.begin(), candidates.end(), [](const Candidate &a, const Candidate &b) {
      return a.distance != b.distance ? a.distance < b.distance : a.elsewhere < b.elsewhere;
    });
    std::vector<std::string> paths;
    // names much farther away than the best one would only distract
    for (const Candidate &candidate : candidates)
      if (paths.size() < 3 && candidate.distance <= candidates.front().distance + 1)
        paths.push_back(candidate.path);
    return paths;
  }

  std::string
  entry_text(const Scene &scene, const std::string &section, const std::string &name)
  {
    return section + "/" + name + " = " + find_entry(section, name)->get(scene);
  }


  std::string
  path_entry(const RunSettings &scene)
  {
    return scene.rolling_distance > 0 ? "Run/Rolling distance" : "Run/Longest distance";
  }


  std::string
  path_text(const RunSettings &scene)
  {
    return path_entry(scene) + " = " + rounded_mm(scene.path());
  }
} // namespace wheelrail
