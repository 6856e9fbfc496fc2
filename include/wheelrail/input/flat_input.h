#pragma once

#include <wheelrail/input/problems.h>

#include <string>
#include <vector>

namespace wheelrail
{
  /// One `set Name = value` of a file or of the command line, not yet understood.
  struct Assignment
  {
    std::string section; ///< empty outside all subsections
    std::string name;
    std::string value; ///< without comment and outer blanks; of files, the names found (found_files())
    Place       place;
    std::string before;      ///< where the same file sets the entry already; empty if it does not
    std::string replaced_at; ///< where a file that overrides it sets it; empty if this one is in force

    /// "Section/Name".
    std::string
    path() const
    {
      return section.empty() ? name : section + "/" + name;
    }
  };

  /// A subsection line.
  struct SectionLine
  {
    std::string name;
    Place       place;
  };

  /// An input text with the files that it includes written out: what is set where, and what could not be
  /// read.
  struct FlatInput
  {
    std::vector<Assignment>  assignments;
    std::vector<SectionLine> sections;
    std::vector<Problem>     problems;
    /// The text without include and continued lines. What another file replaces has become a comment, so
    /// that every entry is set once.
    std::string text;
  };

  /// Reads the lines `set Name = value`, `subsection Name`, `end`, `include FILE`, blank lines and `#`
  /// comments; a line that ends with a backslash continues in the next one. Keywords may be written in
  /// capital letters; line ends of LF, CRLF or CR and a UTF-8 byte order mark are accepted.
  ///
  /// `name` is the file name for messages; the path of an included file counts from the folder of the file
  /// that includes it. A file overrides what it includes, in whatever order the lines stand; of
  /// two included files the later one overrides. The output folder of an included scene is not taken over.
  /// Never throws for a fault in the text or for a file that cannot be read: all faults are in `problems`.
  FlatInput
  flatten_input(const std::string &text, const std::string &name);

  /// The same from JSON or XML as deal.II's ParameterHandler prints it, or from JSON with values alone
  /// ({"Run": {"Rolling distance": "30 mm"}}); places have no lines. The text is that of a parameter file.
  FlatInput
  flatten_tree(const std::string &text, const std::string &name, bool is_xml);

  /// The value of an entry with the files it names: they are looked for where the command is given, then
  /// beside `file`, which sets it. Values of other entries stay.
  std::string
  found_files(const Assignment &of, const std::string &value, const std::string &file);

  /// Reads "Section/Name = value" of the command line option --set. Throws InputError for another form.
  Assignment
  parse_set(const std::string &set);
} // namespace wheelrail
