#include <wheelrail/base/errors.h>
#include <wheelrail/base/format_text.h>
#include <wheelrail/input/entries.h>
#include <wheelrail/input/flat_input.h>
#include <wheelrail/input/input_file.h>
#include <wheelrail/input/parameter_handler.h>
#include <wheelrail/input/parameters.h>

#include <algorithm>
#include <filesystem>
#include <set>
#include <utility>

namespace wheelrail
{
  namespace
  {
    /// A file with more faults than this is none of ours, and not worth the search for similar names.
    constexpr std::size_t most_problems = 1000;

    /// Whether name and value of an assignment are accepted; what is wrong is added to `problems`.
    void
    check(const Assignment &assignment, std::vector<Problem> &problems)
    {
      const Place      &place = assignment.place;
      const std::string where = place.text + ": " + shown_text(assignment.path());
      if (!section_exists(assignment.section))
        {
          // in a file the line of the subsection has been reported
          if (place.order == Place::last_line)
            problems.push_back({where + ": " + unknown_section(assignment.section), place.order});
          return;
        }
      const Entry *const entry = find_entry(assignment.section, assignment.name);
      if (entry == nullptr)
        {
          problems.push_back(
            {where + ": " + unknown_entry(assignment.section, assignment.name, assignment.value),
             place.order});
          return;
        }
      if (!assignment.before.empty())
        problems.push_back({where + ": set a second time" +
                              (assignment.before == place.text ? "" : ", first at " + assignment.before) +
                              "; keep one of them",
                            place.order});
      try
        {
          Scene trial;
          entry->set(trial, assignment.value);
        }
      catch (const InputError &error)
        {
          problems.push_back(
            {where + " = " + shown_text(assignment.value) + ": " + error.what(), place.order});
        }
    }

    /// The entry that a sentence begins with, "Section/Name = value: ..." or "Section/Name: ...".
    std::string
    entry_of(const std::string &sentence)
    {
      return sentence.substr(0, std::min(sentence.find(" = "), sentence.find(": ")));
    }

    std::vector<Assignment>
    parse_sets(const std::vector<std::string> &sets, std::vector<Problem> &problems)
    {
      std::vector<Assignment> assignments;
      std::set<std::string>   paths;
      for (const std::string &set : sets)
        try
          {
            assignments.push_back(parse_set(set));
            if (!paths.insert(assignments.back().path()).second)
              assignments.back().before = assignments.back().place.text;
          }
        catch (const InputError &error)
          {
            problems.push_back({error.what()});
          }
      return assignments;
    }
  } // namespace


  SceneInput
  scene_from_text(const std::string &text, const std::string &name, const std::vector<std::string> &sets)
  {
    const std::string ending = std::filesystem::path(name).extension();
    FlatInput input = ending == ".json" || ending == ".xml" ? flatten_tree(text, name, ending == ".xml")
                                                            : flatten_input(text, name);
    std::vector<Problem>         &problems        = input.problems;
    const std::vector<Assignment> on_command_line = parse_sets(sets, problems);
    for (const SectionLine &section : input.sections)
      if (problems.size() < most_problems && !section_exists(section.name))
        problems.push_back({section.place.text + ": subsection " + shown_text(section.name) + ": " +
                              unknown_section(section.name),
                            section.place.order});
    std::vector<Assignment> all = input.assignments;
    all.insert(all.end(), on_command_line.begin(), on_command_line.end());
    for (const Assignment &assignment : all)
      if (problems.size() < most_problems)
        check(assignment, problems);
    require_no_problems(std::move(problems), name);

    SceneInput result{{}, name, input.text, {}};
    const auto is_replaced = [](const Assignment &one) { return !one.replaced_at.empty(); };
    all.erase(std::remove_if(all.begin(), all.end(), is_replaced), all.end());
    parse_entries(result.text, all, result.scene);
    for (const Assignment &assignment : all)
      result.origin[assignment.path()] = assignment.place;
    if (const std::filesystem::path file = name;
        !file.extension().empty() && !result.origin.count("Output/Folder"))
      result.scene.folder = "output/" + file.stem().string();
    return result;
  }


  std::string
  with_place(const std::string &sentence, const SceneInput &input)
  {
    const auto placed = [&](const std::string &path, const std::string &before) {
      const auto origin = input.origin.find(path);
      return origin == input.origin.end() || origin->second.order == Place::last_line
               ? ""
               : origin->second.text + ": " + before + sentence;
    };
    if (const std::string said = placed(entry_of(sentence), ""); !said.empty())
      return said;
    for (const Entry &entry : entries())
      if (entry.names_files && sentence.rfind(entry.get(input.scene) + ":", 0) == 0)
        if (const std::string said = placed(entry.path(), entry.path() + ": "); !said.empty())
          return said;
    return sentence;
  }


  SceneInput
  read_scene(const std::string &prm_path, const std::vector<std::string> &sets)
  {
    return scene_from_text(read_input_file(prm_path), prm_path, sets);
  }


  void
  require_none(const std::vector<std::string> &errors, const SceneInput &input)
  {
    std::vector<Problem> problems;
    for (const std::string &sentence : errors)
      {
        const auto  origin = input.origin.find(entry_of(sentence));
        const Place place  = origin == input.origin.end() ? Place{input.name} : origin->second;
        problems.push_back({place.text + ": " + sentence, place.order});
      }
    require_no_problems(std::move(problems), input.name);
  }
} // namespace wheelrail
