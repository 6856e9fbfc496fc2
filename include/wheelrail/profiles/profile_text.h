#pragma once

// What the readers of the profile formats share: lines, fields and numbers of a text.

#include <wheelrail/profiles/profile_formats.h>
#include <wheelrail/tables/text_rows.h>

#include <map>
#include <string>
#include <vector>

namespace wheelrail
{
  /// A text of the file as a message may show it: in quotes, short and printable.
  std::string
  shown(const std::string &text);

  /// "1 point", "3 points".
  std::string
  counted(std::size_t n, const std::string &what);

  /// The fields of a line of columns: blanks, tabs, commas and semicolons separate.
  std::vector<std::string>
  fields_of(const std::string &line);

  /// What is among the numbers of the points and is left out.
  struct LeftOut
  {
    std::size_t  switched_off = 0;               ///< lines that begin with a quotation mark
    std::size_t  words        = 0;               ///< lines with words behind their numbers
    unsigned int first_off = 0, first_words = 0; ///< the first line of each kind

    /// Adds a sentence for each kind that there is.
    void
    tell(std::vector<std::string> &notes) const;
  };

  /// Whether a line begins with a quotation mark, by which MiniProf switches lines off; counts it.
  bool
  is_switched_off(const Line &line, LeftOut &left_out);

  /// The numbers of a line of columns up to a comment (!, #, %) or the first field that is none; words there
  /// are counted. Throws InputError when one of the first `needed` fields is none.
  std::vector<double>
  numbers_of(const Line &line, std::size_t needed, const std::string &file, LeftOut &left_out);

  /// Index of the line with which the points begin: the first of five or more lines (comments and lines that
  /// are switched off aside) that begin with a number, or of those that there are. Headings of words,
  /// "Key=value" and a few numbers stand before it, and one line of numbers that an empty line follows.
  std::size_t
  begin_of_points(const std::vector<Line> &lines);

  /// Writes the rows of numbers from the line of index `begin` on with decimal points and blanks between the
  /// cells; an empty cell becomes "-". Returns whether they had decimal commas. Throws InputError, see
  /// row_format().
  bool
  take_row_format(std::vector<Line> &lines, std::size_t begin, const std::string &file);

  /// Adds a point; throws InputError when there are too many or a coordinate is beyond 1e9.
  void
  add_point(FileContent &content, const Point2 &p, unsigned int line, const std::string &file);

  /// The "name = value" lines of a header by their names in lower case.
  struct HeaderValues
  {
    std::string                 file;
    std::map<std::string, Line> texts;

    /// Keeps the line when it has the form, and returns whether it had.
    bool
    take(const Line &line);

    /// The number of that name, or `otherwise` when it is not there or has no value; words behind it are left
    /// out. Throws InputError when it is no number.
    double
    number(const std::string &name, double otherwise) const;

    /// Whether a value follows that name.
    bool
    has(const std::string &name) const;
  };

  /// Readers of SIMPACK and MiniProf files, see parse_profile_text(); the points of the latter begin with the
  /// line of index `begin`.
  FileContent
  parse_simpack(const std::vector<Line> &lines, const std::string &file);
  FileContent
  parse_miniprof(const std::vector<Line> &lines, std::size_t begin, const std::string &file);
} // namespace wheelrail
