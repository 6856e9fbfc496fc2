#pragma once

// What the readers of the profile formats share: lines, fields and numbers of a text.

#include <wheelrail/geometry/profile_formats.h>

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace wheelrail
{
  /// A line without surrounding blanks.
  struct Line
  {
    std::string  text;
    unsigned int number = 0; ///< counted from 1
  };

  /// The lines of a text that hold more than blanks.
  std::vector<Line>
  lines_of(const std::string &text);

  /// The text without blanks at its ends; in lower case; up to the first of the comment marks.
  std::string
  trimmed(const std::string &text);
  std::string
  lower(std::string text);
  std::string
  without_comment(const std::string &line, const char *marks);

  /// "file:line: ", as messages begin.
  std::string
  place(const std::string &file, unsigned int line);

  /// A text of the file as a message may show it: in quotes, short and printable.
  std::string
  shown(const std::string &text);

  /// "1 point", "3 points".
  std::string
  counted(std::size_t n, const std::string &what);

  /// A finite number, or nothing. Fortran's D exponents and a leading plus are understood.
  std::optional<double>
  number_of(std::string text);

  /// The fields of a line of columns: blanks, tabs, commas and semicolons separate.
  std::vector<std::string>
  fields_of(const std::string &line);

  /// The numbers of a line of columns up to the first field that is none. Throws InputError when one
  /// of the first `needed` fields is none.
  std::vector<double>
  numbers_of(const Line &line, std::size_t needed, const std::string &file);

  /// Adds a point; throws InputError when there are too many or a coordinate is beyond 1e9.
  void
  add_point(FileContent &content, const Point2 &p, unsigned int line, const std::string &file);

  /// The "name = value" lines of a header by their names in lower case.
  struct HeaderValues
  {
    std::string                 file;
    std::map<std::string, Line> texts;

    /// Keeps the line when it has the form, and tells whether it had.
    bool
    take(const Line &line);

    /// The number of that name, or `otherwise`; throws InputError when it is no number.
    double
    number(const std::string &name, double otherwise) const;
  };

  /// Reader of SIMPACK files, see parse_profile_text().
  FileContent
  parse_simpack(const std::vector<Line> &lines, const std::string &file);
} // namespace wheelrail
