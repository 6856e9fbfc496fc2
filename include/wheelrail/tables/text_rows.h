#pragma once

// Rows of numbers in a text: what all readers of tables, heights and profiles share.

#include <cstddef>
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

  /// The lines of a text that hold more than blanks, ended by LF, CR LF or CR; a byte order mark is left out.
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

  /// A finite number, or nothing. Fortran's D exponents and a leading plus are understood.
  std::optional<double>
  number_of(std::string text);

  /// How the numbers of all rows of a text are written.
  struct RowFormat
  {
    char separator     = ','; ///< ';', tab, ',' or ' ' (as many blanks or tabs as there are)
    bool decimal_comma = false;
  };

  /// The cells of a row, without blanks and quotation marks around them; separators in quotation marks part
  /// nothing. Numbers with a decimal comma get a point. Empty cells at the end are left out from the cell
  /// `most` on.
  std::vector<std::string>
  cells_of(const std::string &row, const RowFormat &format, std::size_t most = 0);

  /// The format in which most rows hold numbers in the cells `numbers` and, where `cells` is not 0, as many
  /// cells. `words`: words may stand behind a number. Throws InputError, with the line, where some of these
  /// numbers have a decimal point and others a decimal comma, as those with separators of thousands.
  RowFormat
  row_format(const std::vector<Line>        &rows,
             const std::vector<std::size_t> &numbers,
             std::size_t                     cells,
             bool                            words,
             const std::string              &file);
} // namespace wheelrail
