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
        const std::size_t close = line[k] == '\'' ? line.find('\'', k + 1) : std::string::npos;
                    const std::size_t end =
          close != std::string::npos ? close : std::min(line.find_first_of(" \t,=%", k), line.size());
                    if (close != std::string::npos)
          found.push_back({line.substr(k + 1, end - k - 1), true, end});
        else
          found.push_back({line.substr(k, end - k), false, end});
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
    if (line() != first_line)
      fail(line(),
           "more numbers than " + names + " take, which begin in line " + std::to_string(first_line) +
             ": a value is missing there, or digits ask for other values");
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
    for (std::string name : split_list(names, ' '))
      {
        const bool optional = name[0] == '{';
        if (optional)
          name = name.substr(1, name.size() - 2);
        const char kind = std::string("#@'").find(name[0]) != std::string::npos ? name[0] : ' ';
        if (kind != ' ')
          name.erase(0, 1);
        const auto is_value = [&]() {
          return at < std::min(words.size(), group_words) &&
                 (kind == '\'' ? words[at].quoted
                               : !words[at].quoted && (kind == '@' ? contact_angle(words[at].text)
                                                                   : fortran_number(words[at].text)));
        };
        if (!is_value())
          {
            if (optional)
              break;
            if (at < words.size() && at > 0 && is_glued(words[at].text))
              value_of(words[at], kind, name);
            if (at > 0)
              next_line(shown);
          }
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
        if (result.values.empty())
          result.line = line();
        for (; at < std::min(words.size(), array_words) && result.values.size() < count; ++at)
          {
            const std::string &word = words[at].text;
            if (at > 0 && (words[at].quoted ||
                           (!(angles ? contact_angle(word) : fortran_number(word)) && !is_glued(word))))
              break;
            result.values.push_back(value_of(words[at],
                                             angles ? '@' : ' ',
                                             name + ", value " + std::to_string(result.values.size() + 1) +
                                               " of " + std::to_string(count)));
          }
        if (at == array_words && at < words.size() && fortran_number(words[at].text) &&
            result.values.size() < count)
          fail(line(), "more than the 50 numbers that CONTACT reads of a line; write them in several lines");
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
