#include <wheelrail/base/errors.h>
#include <wheelrail/base/format_text.h>
#include <wheelrail/contactfiles/inp_words.h>

#include <algorithm>
#include <cctype>
#include <cmath>

namespace wheelrail
{
  namespace
  {
    constexpr double      degree       = M_PI / 180;
    constexpr std::size_t line_length  = 256; // what CONTACT reads of a line
    constexpr std::size_t group_words  = 20;
    constexpr std::size_t array_words  = 50;
    constexpr const char *word_borders = " \t,=";

    bool
    is_digit(const char c)
    {
      return c >= '0' && c <= '9';
    }

    /// Two numbers without a blank between them, as from columns that were too narrow: -1.13333-1.13333.
    bool
    is_glued(const std::string &word)
    {
      if (fortran_number(word))
        return false;
      for (std::size_t cut = 1; cut < word.size(); ++cut)
        if ((is_digit(word[cut - 1]) || word[cut - 1] == '.') &&
            std::string("+-.").find(word[cut]) != std::string::npos && fortran_number(word.substr(0, cut)) &&
            (fortran_number(word.substr(cut)) || is_glued(word.substr(cut))))
          return true;
      return false;
    }

    /// A word that begins as a number with a point and is none: 0.28o, 4.1mm.
    bool
    is_damaged(const std::string &word)
    {
      const std::size_t point = word.find_first_not_of("0123456789", word.find_first_not_of("+-"));
      return !fortran_number(word) && point != std::string::npos && word[point] == '.' &&
             point + 1 < word.size() && is_digit(word[point + 1]);
    }

    bool
    is_integer(const double value)
    {
      return value == std::floor(value) && std::abs(value) < 2147483648.;
    }
  } // namespace


  std::optional<double>
  fortran_number(const std::string &word)
  {
    std::string number = word;
    for (std::size_t k = 1; k < number.size(); ++k)
      if ((number[k] == '+' || number[k] == '-') && (is_digit(number[k - 1]) || number[k - 1] == '.'))
        {
          number.insert(k, "e");
          break;
        }
    if (const std::size_t plus = number.find("e+"); plus != std::string::npos)
      number.erase(plus + 1, 1);
    // no words such as inf, no two signs
    const std::size_t first = number.find_first_not_of("+-");
    if (first == std::string::npos || first > 1 || !(is_digit(number[first]) || number[first] == '.'))
      return {};
    return number_of(number);
  }

  std::optional<double>
  contact_angle(const std::string &word)
  {
    const char last = word.empty() ? ' ' : static_cast<char>(std::tolower(word.back()));
    if (last != 'd' && last != 'r')
      return fortran_number(word);
    const auto number = fortran_number(word.substr(0, word.size() - 1));
    if (!number)
      return {};
    return *number * (last == 'd' ? degree : 1);
  }


  InpWords::InpWords(const std::string &text, const std::string &file)
    : file(file)
  {
    for (Line &line : lines_of(text))
      if (!words_of(line.text).empty())
        lines.push_back(std::move(line));
  }

  std::vector<InpWords::Word>
  InpWords::words_of(const std::string &line) const
  {
    std::vector<Word> found;
    for (std::size_t k = line.find_first_not_of(word_borders); k < line.size();
         k             = line.find_first_not_of(word_borders, k))
      {
                    if (line[k] == '%')
          break;
        const bool        joined = k > 1 && line[k - 1] == ',' && !found.empty() && found.back().end == k - 1;
                    const std::size_t close  = line[k] == '\'' ? line.find('\'', k + 1) : std::string::npos;
                    const std::size_t end =
          close != std::string::npos ? close : std::min(line.find_first_of(" \t,=%", k), line.size());
                    if (close != std::string::npos)
          found.push_back({line.substr(k + 1, end - k - 1), true, end, joined});
        else
          found.push_back({line.substr(k, end - k), false, end, joined});
        k = close != std::string::npos ? close + 1 : end;
      }
    return found;
  }

  unsigned int
  InpWords::line() const
  {
    return lines.empty() ? 1 : lines[next == 0 ? 0 : next - 1].number;
  }

  void
  InpWords::fail(const unsigned int line, const std::string &text) const
  {
    throw InputError(wheelrail::place(file, line) + text);
  }

  void
  InpWords::next_line(const std::string &needed)
  {
    if (at_end())
      fail(line(),
           "the file ends within " + within + ", where " + needed +
             " should follow; it is cut off, or a digit asks for values that are not there");
    words = words_of(lines[next++].text);
    at    = 0;
  }

  double
  InpWords::value_of(const Word &word, const char kind, const std::string &name) const
  {
    if (word.end > line_length)
      fail(line(),
           name +
             " stands behind the 256 characters that CONTACT reads of a line; write the values in several "
             "lines");
    const auto number = kind == '@' ? contact_angle(word.text) : fortran_number(word.text);
    if (word.quoted || !number)
      fail(line(),
           "\"" + shown_text(word.text, 40) + "\" stands where " + name + " should; " +
             (is_glued(word.text) ? "numbers without a blank between them: separate them"
              : kind == '@'       ? "an angle such as 0.02 (rad) or 1.5d (degrees) is needed"
                                  : "a number is needed"));
    if (kind == '#' && !is_integer(*number))
      fail(line(), name + " = " + shown_text(word.text, 40) + " is no integer");
    return *number;
  }

  bool
  InpWords::is_value(const char kind, const std::size_t most) const
  {
    if (at >= std::min(words.size(), most) || words[at].quoted != (kind == '\''))
      return false;
    return kind == '\'' || (kind == '@' ? contact_angle(words[at].text) : fortran_number(words[at].text));
  }

  /// Turns to the next line for the required value `name`, which the line before does not hold.
  void
  InpWords::go_on(const char kind, const std::string &name, const std::string &names)
  {
    const unsigned int ended = line();
    const std::string  found =
      at < words.size() ? "\"" + shown_text(words[at].text, 40) + "\" stands in its place" : "the line ends";
    if (at < words.size() && (is_glued(words[at].text) || is_damaged(words[at].text)))
      value_of(words[at], kind, name);
    next_line(names);
    const std::string &word = words[0].text;
    if (!is_value(kind, group_words) && (words[0].quoted || !(is_glued(word) || is_damaged(word))))
      fail(ended,
           name + " is missing: " + found + ", and \"" + shown_text(word, 40) + "\" begins line " +
             std::to_string(line()) + ", where it could follow");
  }

  /// Keeps that the next two words may be one number with a decimal comma, such as 0,5: a whole number and
  /// digits, joined by a comma, and no others to them.
  void
  InpWords::note_decimal_comma()
  {
    if (at + 1 >= words.size() || words[at].joined || !words[at + 1].joined ||
        (at + 2 < words.size() && words[at + 2].joined))
      return;
    const std::string &whole = words[at].text, &digits = words[at + 1].text;
    if (whole.find_first_not_of("0123456789", whole.find_first_of("+-") == 0 ? 1 : 0) == std::string::npos &&
        is_digit(digits[0]) && digits.find('.') == std::string::npos && contact_angle(digits))
      decimal = wheelrail::place(file, line()) + "\"" + whole + "," + digits + "\" reads as two numbers, " +
                whole + " and " + digits;
  }

  /// Called when more numbers stand in the line than `names` need.
  void
  InpWords::check_decimal_comma(const std::string &names) const
  {
    if (!decimal.empty())
      throw InputError(decimal + ", and the line has more numbers than " + names +
                       " need; write a decimal point, or a blank behind a comma between two numbers");
  }

  void
  InpWords::check_rest(const std::string &names, const unsigned int first_line)
  {
    if (at >= words.size() || at >= group_words || words[at].quoted)
      return;
    const std::string &word = words[at].text;
    if (is_glued(word))
      fail(line(),
           "\"" + shown_text(word, 40) + "\" are numbers without a blank between them: separate them");
    if (!fortran_number(word))
      return;
    check_decimal_comma(names);
    if (line() != first_line)
      fail(first_line,
           names + " go on to line " + std::to_string(line()) +
             ", which has more numbers than they take: a value is missing, or digits ask for other values");
    notes.push_back(wheelrail::place(file, line()) + "the numbers from " + word + " on are not read; " +
                    names + " stand before them");
  }

  InpGroup
  InpWords::group(const std::string &names)
  {
    InpGroup    result;
    std::string shown = names; // as messages show them
    shown.erase(std::remove_if(shown.begin(),
                               shown.end(),
                               [](const char c) { return std::string("#@'").find(c) != std::string::npos; }),
                shown.end());
    next_line(shown);
    result.line = line();
    decimal.clear();
    for (std::string name : split_list(names, ' '))
      {
        const bool optional = name[0] == '{';
        if (optional)
          name = name.substr(1, name.size() - 2);
        const char kind = std::string("#@'").find(name[0]) != std::string::npos ? name[0] : ' ';
        if (kind != ' ')
          name.erase(0, 1);
        if (optional && !is_value(kind, group_words))
          break;
        if (optional)
          check_decimal_comma(shown);
        else if (at > 0 && !is_value(kind, group_words))
          go_on(kind, name, shown);
        if (kind == '\'')
          {
            if (!words[at].quoted)
              fail(line(),
                   "\"" + shown_text(words[at].text, 40) + "\" stands where " + name +
                     " should; a text in single quotation marks is needed, 'name'");
            result.text = words[at].text;
          }
        else
          result.values.push_back(value_of(words[at], kind, name));
        if (kind != '#')
          note_decimal_comma();
        ++at;
      }
    check_rest(shown, result.line);
    return result;
  }

  InpGroup
  InpWords::array(const std::size_t count, const std::string &name, const bool angles)
  {
    InpGroup result;
    while (result.values.size() < count)
      {
        next_line(name);
        decimal.clear();
        if (result.values.empty())
          result.line = line();
        for (; at < std::min(words.size(), array_words) && result.values.size() < count; ++at)
          {
            const std::string &word = words[at].text;
            if (at > 0 && (words[at].quoted || (!is_value(angles ? '@' : ' ', array_words) &&
                                                !is_glued(word) && !is_damaged(word))))
              break;
            note_decimal_comma();
            result.values.push_back(value_of(words[at],
                                             angles ? '@' : ' ',
                                             name + ", value " + std::to_string(result.values.size() + 1) +
                                               " of " + std::to_string(count)));
          }
        if (at == array_words && at < words.size() && fortran_number(words[at].text) &&
            result.values.size() < count)
          fail(line(), "more than the 50 numbers that CONTACT reads of a line; write them in several lines");
        if (result.values.size() == count && is_value(' ', array_words))
          check_decimal_comma(name);
      }
    return result;
  }

  std::string
  InpWords::control_word(const std::string &letters)
  {
    next_line("control word " + letters);
    const std::string &word = words[at++].text;
    if (!std::all_of(word.begin(), word.end(), is_digit) || word.size() > letters.size())
      fail(line(),
           "\"" + shown_text(word, 40) + "\" stands where the digits " + letters + " should; at most " +
             std::to_string(letters.size()) + " digits in one word are needed");
    return std::string(letters.size() - word.size(), '0') + word;
  }

  std::optional<int>
  InpWords::further_integer(const std::string &name)
  {
    if (at >= words.size() || words[at].quoted || !fortran_number(words[at].text))
      return {};
    return int(value_of(words[at++], '#', name));
  }
} // namespace wheelrail
