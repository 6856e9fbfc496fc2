#include <wheelrail/base/errors.h>
#include <wheelrail/base/quantity.h>
#include <wheelrail/geometry/profile_text.h>

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
  lines_of(const std::string &text)
  {
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

  std::vector<double>
  numbers_of(const Line &line, const std::size_t needed, const std::string &file)
  {
    const std::vector<std::string> fields = fields_of(line.text);
    std::vector<double>            numbers;
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
                       std::to_string(numbers.size()) + " number" + (numbers.size() == 1 ? "" : "s") +
                       "; a line of points holds two: lateral and vertical coordinate");
    return numbers;
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
    const auto found = texts.find(name);
    if (found == texts.end())
      return otherwise;
    const auto value = number_of(found->second.text);
    if (!value || std::abs(*value) > 1e12)
      throw InputError(place(file, found->second.number) + name + " = " + shown(found->second.text) +
                       ": a number is needed");
    return *value;
  }
} // namespace wheelrail
