#include <wheelrail/base/choices.h>
#include <wheelrail/base/errors.h>
#include <wheelrail/base/shown_text.h>
#include <wheelrail/input/input_file.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>

namespace wheelrail
{
  namespace
  {
    std::string
    trim(const std::string &text)
    {
      const char *const blanks = " \t\r";
      const std::size_t first = text.find_first_not_of(blanks), last = text.find_last_not_of(blanks);
      return first == std::string::npos ? "" : text.substr(first, last - first + 1);
    }

    /// First word and the trimmed rest of a line.
    std::pair<std::string, std::string>
    split_word(const std::string &line)
    {
      const std::size_t end = line.find_first_of(" \t");
      return end == std::string::npos ? std::make_pair(line, std::string())
                                      : std::make_pair(line.substr(0, end), trim(line.substr(end)));
    }

    /// The lines of one file, read from top to bottom.
    struct Reader
    {
      std::string file;
      InputText   input;
      std::string section, section_origin; ///< empty when no subsection is open

      void
      read(const std::string &line, const unsigned int number)
      {
        const std::string origin = file + ":" + std::to_string(number);
        const std::string text   = trim(line.substr(0, line.find('#')));
        if (text.empty())
          return;
        const auto [word, rest] = split_word(text);
        if (word == "set")
          read_set(rest, origin);
        else if (word == "subsection")
          open(rest, origin);
        else if (text == "end")
          close(origin);
        else
          input.problems.push_back(origin + ": \"" + shown_text(text) +
                                   "\": a line starts with set, subsection, end or #; an entry is written "
                                   "\"set Name = value\"");
      }

      void
      read_set(const std::string &rest, const std::string &origin)
      {
        const std::size_t equal = rest.find('=');
        const std::string name  = trim(rest.substr(0, equal));
        if (equal == std::string::npos || name.empty())
          input.problems.push_back(origin + ": \"set " + shown_text(rest) +
                                   "\": an entry is written \"set Name = value\"");
        else
          input.assignments.push_back({section, name, trim(rest.substr(equal + 1)), origin});
      }

      void
      open(const std::string &name, const std::string &origin)
      {
        if (name.empty())
          input.problems.push_back(origin + ": subsection without a name");
        if (!section_origin.empty())
          input.problems.push_back(origin + ": subsection " + shown_text(name) + " inside subsection " +
                                   shown_text(section) + " (" + section_origin +
                                   "): an \"end\" is missing before it");
        section        = name;
        section_origin = origin;
        input.sections.push_back({name, origin});
      }

      void
      close(const std::string &origin)
      {
        if (section_origin.empty())
          input.problems.push_back(origin + ": \"end\" without a subsection before it; remove it");
        section.clear();
        section_origin.clear();
      }

      void
      finish()
      {
        if (!section_origin.empty())
          input.problems.push_back(section_origin + ": subsection " + shown_text(section) +
                                   " is not closed: an \"end\" is missing");
      }
    };

    /// A parameter file in the same folder whose name resembles that of `path`, or nothing.
    std::string
    nearest_file(const std::filesystem::path &path)
    {
      std::error_code             code;
      const std::filesystem::path folder = path.has_parent_path() ? path.parent_path() : ".";
      std::vector<std::string>    names;
      for (const auto &file : std::filesystem::directory_iterator(folder, code))
        if (file.path().extension() == ".prm")
          names.push_back(file.path().filename().string());
      std::sort(names.begin(), names.end());
      const std::string nearest = nearest_choice(path.filename().string(), names);
      return nearest.empty() ? "" : (path.parent_path() / nearest).string();
    }
  } // namespace

  InputText
  parse_input(const std::string &text, const std::string &name)
  {
    Reader             reader{name, {}, {}, {}};
    const bool         has_mark = text.compare(0, 3, "\xEF\xBB\xBF") == 0;
    std::istringstream lines(has_mark ? text.substr(3) : text);
    unsigned int       number = 0;
    for (std::string line; std::getline(lines, line);)
      reader.read(line, ++number);
    reader.finish();
    return reader.input;
  }

  void
  parse_set(const std::string &set, InputText &input)
  {
    const std::size_t equal = set.find('=');
    const std::string path  = trim(set.substr(0, equal));
    const std::size_t slash = path.find('/');
    const std::string name  = trim(slash == std::string::npos ? path : path.substr(slash + 1));
    // a comment ends the value as in a file, so that what is written down reads back the same
    const std::string value = equal == std::string::npos ? "" : set.substr(equal + 1);
    if (equal == std::string::npos || name.empty())
      input.problems.push_back(
        "--set \"" + shown_text(set) +
        "\": the form is --set \"Section/Entry = value\", such as --set \"Wheelset/Velocity "
        "= 140 km/h\"");
    else
      input.assignments.push_back({slash == std::string::npos ? "" : trim(path.substr(0, slash)),
                                   name,
                                   trim(value.substr(0, value.find('#'))),
                                   "--set"});
  }

  std::string
  read_input_file(const std::string &path)
  {
    namespace fs = std::filesystem;
    std::error_code code;
    if (!fs::exists(path, code))
      {
        const std::string nearest = nearest_file(path);
        throw InputError(path + ": no such file" + (nearest.empty() ? "" : "; the nearest is " + nearest));
      }
    if (fs::is_directory(path, code))
      throw InputError(path + ": a folder; a parameter file (.prm) is needed");
    std::ifstream file(path, std::ios::binary);
    if (!file)
      throw InputError(path + ": cannot be read; check its permissions");

    constexpr std::size_t largest = 1 << 20;
    std::string           text;
    for (char c; text.size() <= largest && file.get(c);)
      text += c;
    if (text.size() > largest)
      throw InputError(path + ": larger than 1 MiB; this is no parameter file");
    const auto is_binary = [](const char c) {
      return static_cast<unsigned char>(c) < 32 && c != '\n' && c != '\r' && c != '\t';
    };
    if (std::any_of(text.begin(), text.end(), is_binary))
      throw InputError(path + ": not a text file; a parameter file (.prm) is needed");
    if (trim(text).find_first_not_of("\n \t\r") == std::string::npos)
      throw InputError(path + ": empty; \"./wheelrail parameters\" prints a complete parameter file");
    return text;
  }
} // namespace wheelrail
