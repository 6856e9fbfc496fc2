#include <wheelrail/base/errors.h>
#include <wheelrail/profiles/profile_text.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace wheelrail
{
  std::string
  shown(const std::string &text)
  {
    std::string result;
    for (const char c : text.substr(0, 40))
      result += c >= 32 && c < 127 ? c : '?';
    return "\"" + result + (text.size() > 40 ? "...\"" : "\"");
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
  } // namespace

  bool
  take_row_format(std::vector<Line> &lines, const std::size_t begin, const std::string &file)
  {
    std::vector<Line>        rows;
    std::vector<std::size_t> of;
    for (std::size_t i = begin; i < lines.size(); ++i)
      if (starts_with_number(lines[i].text))
        {
          rows.push_back({without_comment(lines[i].text, "!#%"), lines[i].number});
          of.push_back(i);
        }
    const RowFormat format = row_format(rows, {0, 1}, 0, true, file);
    for (std::size_t i = 0; i < rows.size(); ++i)
      {
        std::string text;
        for (const std::string &cell : cells_of(rows[i].text, format))
          text += (text.empty() ? "" : " ") + (cell.empty() ? "-" : cell);
        lines[of[i]].text = text;
      }
    return format.decimal_comma;
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
    const std::vector<std::string> fields = cells_of(text, {' ', false});
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
