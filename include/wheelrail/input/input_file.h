#pragma once

#include <string>
#include <vector>

namespace wheelrail
{
  /// One `set Name = value` of a file or of the command line, not yet understood.
  struct Assignment
  {
    std::string section; ///< empty outside all subsections
    std::string name;
    std::string value;  ///< without comment and outer blanks
    std::string origin; ///< "prm/x.prm:12", or "--set" for the command line
  };

  /// A subsection line.
  struct SectionLine
  {
    std::string name;
    std::string origin;
  };

  /// The syntax of an input text: what is set where, and what could not be read.
  struct InputText
  {
    std::vector<Assignment>  assignments;
    std::vector<SectionLine> sections;
    std::vector<std::string> problems; ///< whole sentences with file and line
  };

  /// Reads the lines `set Name = value`, `subsection Name`, `end`, blank lines and `#` comments;
  /// CRLF line ends and a UTF-8 byte order mark are accepted. `name` is the file name for messages.
  /// Never throws for a fault in the text: all faults are in `problems`, in the order of lines.
  InputText
  parse_input(const std::string &text, const std::string &name);

  /// Reads "Section/Name = value" of the command line option --set; a fault is added to `problems`
  /// of `input`.
  void
  parse_set(const std::string &set, InputText &input);

  /// The text of a parameter file. Throws InputError when there is no such file (and names the
  /// nearest in that folder), when it is a folder, unreadable, empty, too large or not a text.
  std::string
  read_input_file(const std::string &path);
} // namespace wheelrail
