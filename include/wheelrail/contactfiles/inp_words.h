#pragma once

#include <wheelrail/tables/text_rows.h>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace wheelrail
{
  /// A number as Fortran reads it: 0.1e-7 also as .1d-07 or .1-07. Nothing for other words.
  std::optional<double>
  fortran_number(const std::string &word);

  /// The same with the suffix d or D for degrees, r or R for radians [rad]. 90d0 is 90 rad.
  std::optional<double>
  contact_angle(const std::string &word);

  /// Values of an input file that belong together.
  struct InpGroup
  {
    unsigned int        line = 0; ///< of the first value
    std::vector<double> values;   ///< optional ones at the end may be missing
    std::string         text;     ///< of the quoted word, if the group has one

    /// The value at `index`, or `otherwise` when it is missing.
    double
    value(std::size_t index, double otherwise = 0) const
    {
      return index < values.size() ? values[index] : otherwise;
    }

    /// The values from `first` on.
    std::vector<double>
    from(std::size_t first) const
    {
      return {values.begin() + std::ptrdiff_t(first), values.end()};
    }
  };

  /// Reads an input file of the program CONTACT value by value. Blanks, tabs, commas and = separate words, %
  /// outside of quotation marks begins a comment. All functions throw InputError with file and line.
  class InpWords
  {
  public:
    /// `file` names the text in messages.
    InpWords(const std::string &text, const std::string &file);

    /// The values that a line begins with; required ones may go on in the next lines, behind words that are
    /// no values. `names` lists them, separated by blanks: # before a name asks for an integer, @ for an
    /// angle, ' for a quoted text; names in braces are optional and stand in the line of the last required
    /// value.
    InpGroup
    group(const std::string &names);

    /// An array of `count` values over as many lines as it needs; the rest of its last line is left out.
    InpGroup
    array(std::size_t count, const std::string &name, bool angles = false);

    /// A control word of `letters`, such as PBTNFS: their digits, leading zeros added.
    std::string
    control_word(const std::string &letters);

    /// Whether an integer stands behind the values that were read last, in their line; it is read.
    std::optional<int>
    further_integer(const std::string &name);

    /// Whether no words are left.
    bool
    at_end() const
    {
      return next >= lines.size();
    }

    /// Line of the values that were read last; of the last line when the file is at its end.
    unsigned int
    line() const;

    [[noreturn]] void
    fail(unsigned int line, const std::string &text) const;

    /// What is said when the file ends too early: "case 3" and the like.
    std::string within = "its first case";
    /// What CONTACT leaves out and a user may have meant, with file and line.
    std::vector<std::string> notes;

  private:
    struct Word
    {
      std::string text;
      bool        quoted = false;
      std::size_t end    = 0;     ///< in its line
      bool        joined = false; ///< to the word before by a comma without blanks
    };

    std::vector<Word>
    words_of(const std::string &line) const;

    void
    next_line(const std::string &needed);

    bool
    is_value(char kind, std::size_t most) const;

    double
    value_of(const Word &word, char kind, const std::string &name) const;

    void
    go_on(char kind, const std::string &name, const std::string &names);

    void
    note_decimal_comma();

    void
    check_decimal_comma(const std::string &names) const;

    void
    check_rest(const std::string &names, unsigned int first_line);

    std::string       file;
    std::vector<Line> lines;    ///< with words
    std::size_t       next = 0; ///< line
    std::vector<Word> words;    ///< of the line before `next`
    std::size_t       at = 0;   ///< the next of them
    std::string       decimal;  ///< what may be a number with a decimal comma in the values read last
  };
} // namespace wheelrail
