#include <wheelrail/base/choices.h>
#include <wheelrail/base/errors.h>
#include <wheelrail/base/shown_text.h>
#include <wheelrail/input/entries.h>
#include <wheelrail/input/input_file.h>
#include <wheelrail/input/parameters.h>
#include <wheelrail/input/special_entries.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <sstream>

namespace wheelrail
{
  namespace
  {
    using Sentences = std::vector<std::string>;

    /// A file with more faults than this is none of ours, and not worth the search for similar names.
    constexpr std::size_t most_problems = 1000;

    /// As many faults as a screen holds.
    constexpr std::size_t shown_problems = 25;

    std::string
    join(const Sentences &parts, const std::string &between)
    {
      std::string text;
      for (const std::string &part : parts)
        text += (text.empty() ? "" : between) + part;
      return text;
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
      if (!nearest.empty())
        return "no such subsection; the nearest is " + nearest;
      return "no such subsection; there are " + join(names, ", ");
    }

    std::string
    unknown_entry(const std::string &section, const std::string &name)
    {
      const Sentences nearest = nearest_entries(section, name);
      if (!nearest.empty())
        return "no such entry; the nearest " + std::string(nearest.size() == 1 ? "is " : "are ") +
               join(nearest, ", ");
      Sentences names;
      for (const Entry &entry : entries())
        if (entry.section == section)
          names.push_back(entry.name);
      return "no such entry; " + (section.empty() ? std::string("outside the subsections") : section) +
             " has " + join(names, ", ");
    }

    /// Turns assignments into a scene and keeps where each entry was set.
    struct SceneReader
    {
      Scene                              scene;
      Sentences                          problems;
      std::map<std::string, std::string> origin; ///< by path

      void
      read(const Assignment &assignment)
      {
        const bool        on_command_line = assignment.origin == "--set";
        const std::string path =
          assignment.section.empty() ? assignment.name : assignment.section + "/" + assignment.name;
        const std::string where = assignment.origin + ": " + shown_text(path);
        if (!section_exists(assignment.section))
          {
            // in a file the line of the subsection has been reported
            if (on_command_line)
              problems.push_back(where + ": " + unknown_section(assignment.section));
            return;
          }
        const Entry *const entry = find_entry(assignment.section, assignment.name);
        if (entry == nullptr)
          {
            problems.push_back(where + ": " + unknown_entry(assignment.section, assignment.name));
            return;
          }
        const auto before = origin.find(path);
        // the command line overrides the file, but a second one on the same level is a mistake
        if (before != origin.end() && (before->second == "--set") == on_command_line)
          problems.push_back(where + ": set a second time" +
                             (on_command_line ? "" : ", first at " + before->second) + "; keep one of them");
        origin[path] = assignment.origin;
        set(*entry, assignment.value, where);
      }

      void
      set(const Entry &entry, const std::string &value, const std::string &where)
      {
        try
          {
            entry.set(scene, value);
          }
        catch (const InputError &error)
          {
            problems.push_back(where + " = " + shown_text(value) + ": " + error.what());
          }
      }
    };

    /// Line number of "file:12: ...", so that problems of syntax and of meaning stand in the order
    /// of the file; those without a line and those of the command line come last.
    unsigned long
    line_of(const std::string &problem, const std::string &file)
    {
      const std::string start    = file + ":";
      const bool        has_line = problem.compare(0, start.size(), start) == 0 &&
                            std::isdigit(static_cast<unsigned char>(problem[start.size()]));
      return has_line ? std::stoul(problem.substr(start.size())) : ~0ul;
    }

    void
    require_no_problems(Sentences problems, const std::string &name)
    {
      std::stable_sort(problems.begin(), problems.end(), [&](const auto &a, const auto &b) {
        return line_of(a, name) < line_of(b, name);
      });
      if (problems.size() > shown_problems)
        {
          const std::size_t rest = problems.size() - shown_problems;
          problems.resize(shown_problems);
          problems.push_back(name + ": " + std::to_string(rest) + " more faults; correct these first");
        }
      if (!problems.empty())
        throw InputError(join(problems, "\n"));
    }

    /// Breaks `text` at blanks into lines of at most `width` characters, each after `prefix`.
    std::string
    wrap(const std::string &text, const std::string &prefix, const std::size_t width)
    {
      std::istringstream words(text);
      std::string        lines, line;
      for (std::string word; words >> word;)
        {
          if (!line.empty() && prefix.size() + line.size() + 1 + word.size() > width)
            {
              lines += prefix + line + "\n";
              line.clear();
            }
          line += (line.empty() ? "" : " ") + word;
        }
      return lines + (line.empty() ? "" : prefix + line + "\n");
    }

    std::string
    print_entry(const Entry &entry, const Scene &scene)
    {
      const std::string indent = entry.section.empty() ? "" : "  ";
      const std::string value  = entry.get(scene);
      const std::string comment =
        entry.meaning + " Accepted: " + entry.accepted + "." +
        (entry.default_text.empty() || entry.default_text == value ? ""
                                                                   : " Default: " + entry.default_text + ".");
      return wrap(comment, indent + "# ", 100) + indent + "set " + entry.name + " =" +
             (value.empty() ? "" : " " + value) + "\n";
    }
  } // namespace

  SceneInput
  scene_from_text(const std::string &text, const std::string &name, const std::vector<std::string> &sets)
  {
    InputText input = parse_input(text, name);
    for (const std::string &set : sets)
      parse_set(set, input);

    SceneReader reader;
    for (const Entry &entry : entries())
      entry.set(reader.scene, entry.default_text);
    reader.problems = input.problems;
    for (const SectionLine &section : input.sections)
      if (reader.problems.size() < most_problems && !section_exists(section.name))
        reader.problems.push_back(section.origin + ": subsection " + shown_text(section.name) + ": " +
                                  unknown_section(section.name));
    for (const Assignment &assignment : input.assignments)
      if (reader.problems.size() < most_problems)
        reader.read(assignment);
    complete_scene(reader.scene);
    require_no_problems(std::move(reader.problems), name);
    return {reader.scene, name, reader.origin};
  }

  SceneInput
  read_scene(const std::string &prm_path, const std::vector<std::string> &sets)
  {
    return scene_from_text(read_input_file(prm_path), prm_path, sets);
  }

  void
  require_none(const std::vector<std::string> &errors, const SceneInput &input)
  {
    Sentences problems;
    for (const std::string &sentence : errors)
      {
        const auto origin = input.origin.find(sentence.substr(0, sentence.find(" = ")));
        problems.push_back((origin == input.origin.end() ? input.name : origin->second) + ": " + sentence);
      }
    require_no_problems(std::move(problems), input.name);
  }

  std::string
  print_parameters(const Scene &scene)
  {
    std::string text =
      "# All entries of a scene. Entries that are not set take their default.\n"
      "# A number that measures something carries its unit.\n\n";
    std::string open;
    for (const Entry &entry : entries())
      {
        if (entry.section != open)
          {
            text += (open.empty() ? "" : "end\n") + std::string("\nsubsection ") + entry.section + "\n";
            open = entry.section;
          }
        else if (!open.empty())
          text += "\n";
        text += print_entry(entry, scene);
      }
    return text + "end\n";
  }
} // namespace wheelrail
