#include <wheelrail/base/errors.h>
#include <wheelrail/base/line_ends.h>
#include <wheelrail/profiles/profile_text.h>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace wheelrail
{
  std::string
  trimmed(const std::string &text)
  {
    const char *blanks = " \t\r\f\v";
    const auto  first  = text.find_first_not_of(blanks);
    return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(blanks) - first + 1);
  }

  std::string
  lower(std::string text)
  {
    std::transform(text.begin(), text.end(), text.begin(), [](const unsigned char c) {
      return static_cast<char>(c >= 'A' && c <= 'Z' ? c + 32 : c);
    });
    return text;
  }

  std::string
  place(const std::string &file, const unsigned int line)
  {
    return file + ":" + std::to_string(line) + ": ";
  }

  std::string
  shown(const std::string &text)
  {
    std::string result;
    for (const char c : text.substr(0, 40))
      result += c >= 32 && c < 127 ? c : '?';
    return "\"" + result + (text.size() > 40 ? "...\"" : "\"");
  }

  std::vector<Line>
  lines_of(const std::string &whole)
  {
    const std::string mark = "\xEF\xBB\xBF"; // byte order mark of UTF-8
    const std::string text = with_line_feeds(whole.compare(0, 3, mark) == 0 ? whole.substr(3) : whole);
    std::vector<Line> lines;
    unsigned int      number = 0;
    for (std::size_t begin = 0; begin <= text.size();)
      {
        const std::size_t end  = std::min(text.find('\n', begin), text.size());
        std::string       line = trimmed(text.substr(begin, end - begin));
        ++number;
        if (!line.empty())
          lines.push_back({std::move(line), number});
        begin = end + 1;
      }
    return lines;
  }

  std::string
  without_comment(const std::string &line, const char *marks)
  {
    return trimmed(line.substr(0, line.find_first_of(marks)));
  }

  std::optional<double>
  number_of(std::string text)
  {
    if (!text.empty() && text[0] == '+')
      text.erase(0, 1);
    const auto d = text.find_first_of("dD");
    if (d != std::string::npos)
      text[d] = 'e';
    double     value  = 0;
    const auto result = std::from_chars(text.data(), text.data() + text.size(), value);
    if (result.ec != std::errc() || result.ptr != text.data() + text.size() || !std::isfinite(value))
      return {};
    return value;
  }

  std::vector<std::string>
  fields_of(const std::string &line)
  {
    std::vector<std::string> fields;
    std::string              field;
    for (const char c : line + " ")
      if (c == ' ' || c == '\t' || c == ',' || c == ';')
        {
          if (!field.empty())
            fields.push_back(field);
          field.clear();
        }
      else
        field += c;
    return fields;
  }

  void
  add_point(FileContent &content, const Point2 &p, const unsigned int line, const std::string &file)
  {
    if (std::abs(p.x) > 1e9 || std::abs(p.y) > 1e9)
      throw InputError(place(file, line) + "a coordinate above 1e9; a profile is some 0.1 m wide");
    if (content.points.size() == largest_profile_points)
      throw InputError(place(file, line) + "more than " + std::to_string(largest_profile_points) +
                       " points; a profile needs some hundred: keep every tenth");
    content.points.push_back({p, line});
    ++content.listed;
  }

  namespace
  {
    bool
    starts_with_number(const std::string &text)
    {
      const std::vector<std::string> fields = fields_of(without_comment(text, "!#%"));
      return !fields.empty() && number_of(fields[0]);
    }

    /// Whether commas stand between digits although blanks or semicolons already separate the numbers.
    bool
    has_decimal_commas(const std::string &text)
    {
      const auto  digit = [](const char c) { return c >= '0' && c <= '9'; };
      std::string part;
      std::size_t numbers = 0;
      bool        comma   = false;
      for (const char c : text + " ")
        {
          if (c != ' ' && c != '\t' && c != ';')
            {
              part += c;
              continue;
            }
          numbers += !part.empty() && (digit(part[0]) || part[0] == '-' || part[0] == '+');
          for (std::size_t i = 1; i + 1 < part.size(); ++i)
            comma = comma || (part[i] == ',' && digit(part[i - 1]) && digit(part[i + 1]));
          part.clear();
        }
      return comma && numbers > 1;
    }
  } // namespace

  bool
  take_decimal_commas(std::vector<Line> &lines, const std::size_t begin)
  {
    const auto digit                 = [](const char c) { return c >= '0' && c <= '9'; };
    const auto stands_between_digits = [&](const std::string &text, const std::size_t k) {
      return k > 0 && k + 1 < text.size() && digit(text[k - 1]) && digit(text[k + 1]);
    };
    bool commas = false;
    for (std::size_t i = begin; i < lines.size(); ++i)
      {
        const std::string text = without_comment(lines[i].text, "!#%");
        if (!starts_with_number(text))
          continue;
        for (std::size_t k = 0; k < text.size(); ++k)
          if (text[k] == '.' && stands_between_digits(text, k))
            return false;
        commas = commas || has_decimal_commas(text);
      }
    for (std::size_t i = begin; commas && i < lines.size(); ++i)
      for (std::size_t k = 0; k < lines[i].text.size(); ++k)
        if (lines[i].text[k] == ',' && stands_between_digits(lines[i].text, k))
          lines[i].text[k] = '.';
    return commas;
  }

  void
  LeftOut::tell(std::vector<std::string> &notes) const
  {
    if (switched_off > 0)
      notes.push_back(counted(switched_off, "line") +
                      " switched off by a leading quotation mark left out, the first is line " +
                      std::to_string(first_off));
    if (words > 0)
      notes.push_back("words behind the numbers of " + counted(words, "line") +
                      " left out, the first is line " + std::to_string(first_words));
  }

  bool
  is_switched_off(const Line &line, LeftOut &left_out)
  {
    if (line.text[0] != '"')
      return false;
    if (left_out.switched_off++ == 0)
      left_out.first_off = line.number;
    return true;
  }

  std::vector<double>
  numbers_of(const Line &line, const std::size_t needed, const std::string &file, LeftOut &left_out)
  {
    const std::string              text   = without_comment(line.text, "!#%");
    const std::vector<std::string> fields = fields_of(text);
    std::vector<double>            numbers;
    if (has_decimal_commas(text))
      throw InputError(
        place(file, line.number) + shown(text) +
        " has commas and other separators; write a point as decimal mark, and blanks, tabs, commas or "
        "semicolons between the columns");
    for (const std::string &field : fields)
      {
        const auto number = number_of(field);
        if (!number && numbers.size() < needed)
          throw InputError(place(file, line.number) + shown(field) +
                           " is not a number; a line of points holds two: lateral and vertical coordinate");
        if (!number)
          break;
        numbers.push_back(*number);
      }
    if (numbers.size() < needed)
      throw InputError(place(file, line.number) + shown(line.text) + " holds " +
                       counted(numbers.size(), "number") +
                       "; a line of points holds two: lateral and vertical coordinate");
    if (numbers.size() < fields.size() && left_out.words++ == 0)
      left_out.first_words = line.number;
    return numbers;
  }

  std::size_t
  begin_of_points(const std::vector<Line> &lines)
  {
    constexpr unsigned int enough = 5;
    std::size_t            begin = lines.size(), first = lines.size();
    unsigned int           run = 0;
    for (std::size_t i = 0; i < lines.size() && run < enough; ++i)
      {
        if (lines[i].text[0] == '"' || without_comment(lines[i].text, "!#%").empty())
          continue;
        if (!starts_with_number(lines[i].text))
          {
            run = 0;
            continue;
          }
        if (run == 1 && lines[i].number > lines[i - 1].number + 1) // one line of numbers and an empty one
          run = 0;
        if (run++ == 0)
          begin = i;
        first = std::min(first, i);
      }
    return run < enough ? first : begin;
  }

  std::string
  counted(const std::size_t n, const std::string &what)
  {
    return std::to_string(n) + " " + what + (n == 1 ? "" : "s");
  }


  bool
  HeaderValues::take(const Line &line)
  {
    const auto equal = line.text.find('=');
    if (equal == std::string::npos || equal == 0)
      return false;
    texts[lower(trimmed(line.text.substr(0, equal)))] = {trimmed(line.text.substr(equal + 1)), line.number};
    return true;
  }

  double
  HeaderValues::number(const std::string &name, const double otherwise) const
  {
    if (!has(name))
      return otherwise;
    const auto found = texts.find(name);
    const auto words = fields_of(found->second.text);
    const auto value = words.empty() ? std::nullopt : number_of(words[0]);
    if (!value || std::abs(*value) > 1e12)
      throw InputError(place(file, found->second.number) + name + " = " + shown(found->second.text) +
                       ": a number is needed");
    return *value;
  }

  bool
  HeaderValues::has(const std::string &name) const
  {
    const auto found = texts.find(name);
    return found != texts.end() && !found->second.text.empty();
  }
} // namespace wheelrail
