#include <wheelrail/base/errors.h>
#include <wheelrail/base/format_text.h>
#include <wheelrail/base/read_file.h>
#include <wheelrail/input/entries.h>
#include <wheelrail/input/flat_input.h>
#include <wheelrail/input/input_file.h>
#include <wheelrail/profiles/profile_file.h>

#include <boost/algorithm/string/case_conv.hpp>
#include <boost/algorithm/string/trim.hpp>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <map>
#include <sstream>
#include <utility>

namespace wheelrail
{
  namespace
  {
    /// The first word of a line in small letters if it is in capital ones, and the trimmed rest.
    std::pair<std::string, std::string>
    split_word(const std::string &line)
    {
      const std::size_t end  = std::min(line.find(' '), line.size());
      std::string       word = line.substr(0, end);
      if (std::all_of(word.begin(), word.end(), [](const unsigned char c) { return std::isupper(c); }))
        boost::to_lower(word);
      return {word, boost::trim_copy(line.substr(end))};
    }

    /// A line with those that it goes on in.
    struct Line
    {
      unsigned int number; ///< of the first one
      std::string  text;
      bool         is_open = false; ///< ends with a backslash, and so does the file
    };

    /// The lines of a text. A comment ends with its line, so a backslash in it goes on nowhere.
    std::vector<Line>
    lines_of(const std::string &text)
    {
      const bool         has_mark = text.compare(0, 3, "\xEF\xBB\xBF") == 0;
      std::istringstream in(with_line_feeds(has_mark ? text.substr(3) : text));
      std::vector<Line>  lines;
      bool               goes_on = false;
      unsigned int       number  = 0;
      for (std::string line; std::getline(in, line);)
        {
          ++number;
          std::replace(line.begin(), line.end(), '\t', ' ');
          line.erase(line.find_last_not_of(" \r\v\f") + 1);
          const bool joins = goes_on;
          goes_on          = !line.empty() && line.back() == '\\' && line.find('#') == std::string::npos;
          if (goes_on)
            line.pop_back();
          if (joins)
            lines.back().text += line.erase(0, line.find_first_not_of(" \r\v\f"));
          else
            lines.push_back({number, line});
          lines.back().is_open = goes_on;
        }
      return lines;
    }

    /// A file at work, and what is set by it and by the files it includes.
    struct File
    {
      std::string name, path; ///< for messages; as the system knows it
      const File *includer = nullptr;
      std::string section = "", section_place = "";   ///< the open subsection; empty when there is none
      bool        opened                     = false; ///< it was opened by this file
      std::size_t opened_order               = 0;
      std::map<std::string, std::size_t> set = {}; ///< assignments in force, by the path of the entry
      std::map<std::string, std::string> own = {}; ///< places of those of this file itself
    };

    /// Reads a file and, at their places, the files that it includes.
    class Flattener
    {
    public:
      void
      read(const std::string &text, File &file);

      /// What was read; its text once all files are.
      FlatInput
      finish();

    private:
      void
      read_line(const Line &line, File &file);
      void
      read_set(const std::string &rest, const Place &place, File &file);
      void
      open(const std::string &name, const Place &place, File &file);
      void
      close(const Place &place, File &file);
      void
      include(const std::string &name, const Place &place, File &file);
      void
      read_included(const std::string &text, File &&inner, File &file);
      void
      replace(std::size_t assignment, const std::string &place);

      FlatInput                input_;
      std::vector<std::string> lines_;
      std::vector<std::size_t> line_of_; ///< of an assignment
      std::size_t              order_ = 0, included_ = 0;
    };

    void
    Flattener::read(const std::string &text, File &file)
    {
      for (const Line &line : lines_of(text))
        read_line(line, file);
      if (file.opened)
        input_.problems.push_back({file.section_place + ": subsection " + shown_text(file.section) +
                                     " is not closed: an \"end\" is missing",
                                   file.opened_order});
    }

    void
    Flattener::read_line(const Line &line, File &file)
    {
      const Place       place{file.name + ":" + std::to_string(line.number), order_++};
      const std::string text  = boost::trim_copy(line.text.substr(0, line.text.find('#')));
      const auto [word, rest] = split_word(text);
      lines_.push_back(line.text);
      if (line.is_open)
        input_.problems.push_back(
          {place.text + ": the last line ends with a backslash, and no line follows; remove it",
           place.order});
      else if (word == "set")
        read_set(rest, place, file);
      else if (word == "subsection")
        open(rest, place, file);
      else if (word == "end" && rest.empty())
        close(place, file);
      else if (word == "include")
        include(rest, place, file);
      else if (!text.empty())
        input_.problems.push_back({place.text + ": \"" + shown_text(text) +
                                     "\": a line starts with set, subsection, end, include or #; an entry is "
                                     "written \"set Name = value\"",
                                   place.order});
    }

    void
    Flattener::read_set(const std::string &rest, const Place &place, File &file)
    {
      const std::size_t equal = rest.find('=');
      Assignment        assignment{file.section, boost::trim_copy(rest.substr(0, equal)), "", place, "", ""};
      if (equal == std::string::npos || assignment.name.empty())
        {
          input_.problems.push_back(
            {place.text + ": \"set " + shown_text(rest) + "\": an entry is written \"set Name = value\"",
             place.order});
          return;
        }
      const std::string value = boost::trim_copy(rest.substr(equal + 1));
      assignment.value        = found_files(assignment, value, file.name);
      if (std::string &line = lines_.back(); assignment.value != value)
        line.replace(line.find(value, line.find('=')), value.size(), assignment.value);
      const std::string path = assignment.path();
      const auto        here = file.own.find(path);
      if (here != file.own.end())
        assignment.before = here->second;
      else if (const auto included = file.set.find(path); included != file.set.end())
        replace(included->second, place.text);
      file.own[path] = place.text;
      file.set[path] = input_.assignments.size();
      input_.assignments.push_back(assignment);
      line_of_.push_back(lines_.size() - 1);
    }

    void
    Flattener::open(const std::string &name, const Place &place, File &file)
    {
      if (name.empty())
        input_.problems.push_back({place.text + ": subsection without a name", place.order});
      if (!file.section_place.empty())
        input_.problems.push_back({place.text + ": subsection " + shown_text(name) + " inside subsection " +
                                     shown_text(file.section) + " (" + file.section_place +
                                     "): an \"end\" is missing before it",
                                   place.order});
      file.section       = name;
      file.section_place = place.text;
      file.opened        = true;
      file.opened_order  = place.order;
      input_.sections.push_back({name, place});
    }

    void
    Flattener::close(const Place &place, File &file)
    {
      if (!file.opened)
        {
          input_.problems.push_back(
            {place.text + ": \"end\" without a subsection before it; remove it", place.order});
          return;
        }
      file.section.clear();
      file.section_place.clear();
      file.opened = false;
    }

    /// The names of the files from `path` on that include each other up to `file`, and `path` again; empty
    /// when `path` is none of them.
    std::string
    circle(const std::string &path, const File &file)
    {
      std::string names;
      for (const File *at = &file; at != nullptr; at = at->includer)
        {
          names.insert(0, at->name + ", ");
          if (at->path == path)
            return names + at->name;
        }
      return "";
    }

    std::string
    system_path(const std::string &path)
    {
      std::error_code code;
      const auto      found = std::filesystem::weakly_canonical(path, code);
      return code ? path : found.string();
    }

    void
    Flattener::include(const std::string &name, const Place &place, File &file)
    {
      constexpr std::size_t most_files = 100;

      const std::string where = place.text + ": include " + shown_text(name) + ": ";
      const std::string path =
        (std::filesystem::path(file.name).parent_path() / name).lexically_normal().string();
      lines_.back() = "# include " + name;
      if (name.empty())
        input_.problems.push_back(
          {place.text + ": include without a file; write \"include FILE.prm\"", place.order});
      else if (const std::string names = circle(system_path(path), file); !names.empty())
        input_.problems.push_back(
          {where + "files include each other in a circle (" + names + "); remove one of the includes",
           place.order});
      else if (++included_ > most_files)
        input_.problems.push_back(
          {where + "more than 100 files are included in all; put some of them together", place.order});
      else
        try
          {
            read_included(read_input_file(path),
                          {path, system_path(path), &file, file.section, file.section_place},
                          file);
          }
        catch (const InputError &error)
          {
            input_.problems.push_back({where + shown_text(error.what(), 500), place.order});
          }
    }

    void
    Flattener::read_included(const std::string &text, File &&inner, File &file)
    {
      read(text, inner);
      lines_.push_back("# end of " + inner.name);
      for (const auto &[path, assignment] : inner.set)
        {
          if (path == "Output/Folder" && file.section.empty()) // each scene has its own
            {
              replace(assignment, file.name);
              continue;
            }
          if (const auto own = file.own.find(path); own != file.own.end())
            {
              replace(assignment, own->second);
              continue;
            }
          if (const auto earlier = file.set.find(path); earlier != file.set.end())
            replace(earlier->second, input_.assignments[assignment].place.text);
          file.set[path] = assignment;
        }
    }

    void
    Flattener::replace(const std::size_t assignment, const std::string &place)
    {
      input_.assignments[assignment].replaced_at = place;
      std::string &line                          = lines_[line_of_[assignment]];
      line = "# " + boost::trim_copy(line) + " (replaced at " + place + ")";
    }

    FlatInput
    Flattener::finish()
    {
      for (std::string &line : lines_)
        {
          // the end of a comment, to which the next line would be joined
          line.erase(line.find_last_not_of("\\ ") + 1);
          input_.text += line + "\n";
        }
      return std::move(input_);
    }
  } // namespace


  std::string
  found_files(const Assignment &of, const std::string &value, const std::string &file)
  {
    namespace fs              = std::filesystem;
    const Entry *const entry  = find_entry(of.section, of.name);
    const fs::path     folder = fs::path(file).parent_path();
    if (!entry || !entry->names_files || folder.empty())
      return value;
    std::error_code ignored;
    std::string     found;
    bool            any = false;
    for (const std::string &name : split_list(value, ','))
      {
        const bool beside =
          is_file_name(name) && !fs::exists(name, ignored) && fs::exists(folder / name, ignored);
        any = any || beside;
        found += (found.empty() ? "" : ", ") + (beside ? (folder / name).lexically_normal().string() : name);
      }
    return any ? found : value;
  }


  FlatInput
  flatten_input(const std::string &text, const std::string &name)
  {
    Flattener flattener;
    File      file{name, system_path(name)};
    flattener.read(text, file);
    return flattener.finish();
  }


  Assignment
  parse_set(const std::string &set)
  {
    const std::size_t equal = set.find('=');
    const std::string path  = boost::trim_copy(set.substr(0, equal));
    const std::size_t slash = path.find('/');
    const std::string name  = boost::trim_copy(slash == std::string::npos ? path : path.substr(slash + 1));
    if (equal == std::string::npos || name.empty())
      throw InputError("--set \"" + shown_text(set) +
                       "\": the form is --set \"Section/Entry = value\", such as --set \"Wheelset/Velocity "
                       "= 140 km/h\"");
    // in a file a remark would begin there, so that the value would not read back the same
    if (set.find('#') != std::string::npos)
      throw InputError(
        "--set \"" + shown_text(set) +
        "\": # begins a remark in parameter files, so that no value can hold it; write the value "
        "without it");
    return {slash == std::string::npos ? "" : boost::trim_copy(path.substr(0, slash)),
            name,
            boost::trim_copy(set.substr(equal + 1)),
            {"--set"},
            "",
            ""};
  }
} // namespace wheelrail
