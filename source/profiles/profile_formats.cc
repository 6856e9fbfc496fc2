#include <wheelrail/base/errors.h>
#include <wheelrail/profiles/measurement_noise.h>
#include <wheelrail/profiles/profile_text.h>

#include <algorithm>
#include <string>
#include <vector>

namespace wheelrail
{
  namespace
  {
    /// Unit named in a heading as "[mm]", "(m)" or "unit: mm"; 0 when none is. A length in a remark
    /// ("worn by 2 mm") states nothing.
    double
    unit_in(const std::string &heading)
    {
      std::string word, before;
      char        opened = ' ';
      for (const char c : lower(heading) + " ")
        {
          if (c >= 'a' && c <= 'z')
            {
              word += c;
              continue;
            }
          const bool bracketed = (opened == '[' && c == ']') || (opened == '(' && c == ')');
          if ((word == "mm" || word == "m") && (bracketed || before == "unit" || before == "units"))
            return word == "mm" ? 1e-3 : 1;
          if (!word.empty())
            before = word;
          word.clear();
          opened = c;
        }
      return 0;
    }

    /// Throws InputError when a line of points has more columns than profiles have, or another number of them
    /// than the lines before.
    void
    check_columns(const Line        &line,
                  const std::size_t  found,
                  const std::size_t  before,
                  const std::string &file)
    {
      if (found > 5)
        throw InputError(
          place(file, line.number) + shown(line.text) + " holds " + std::to_string(found) +
          " columns; two to five are accepted, the first ones are the lateral and the vertical "
          "coordinate");
      if (before != 0 && before != found)
        throw InputError(place(file, line.number) + shown(line.text) + " holds " + std::to_string(found) +
                         " columns, the lines before " + std::to_string(before) +
                         "; write two in every line");
    }

    FileContent
    parse_columns(const std::vector<Line> &lines, const std::size_t begin, const std::string &file)
    {
      FileContent content;
      LeftOut     left_out;
      content.format      = "two columns";
      std::size_t columns = 0;
      for (std::size_t i = 0; i < lines.size(); ++i)
        {
          if (const double unit = unit_in(lines[i].text);
              i <= begin && unit > 0 && content.metres_per_unit == 0)
            content.metres_per_unit = unit;
          const Line line{without_comment(lines[i].text, "!#%"), lines[i].number};
          if (i < begin || line.text.empty() || is_switched_off(line, left_out))
            continue;
          const std::size_t         words   = left_out.words;
          const std::vector<double> numbers = numbers_of(line, 2, file, left_out);
          add_point(content, {numbers[0], numbers[1]}, line.number, file);
          if (left_out.words > words) // a number among the words is no column
            continue;
          check_columns(line, numbers.size(), columns, file);
          columns = numbers.size();
        }
      left_out.tell(content.notes);
      if (columns > 2)
        content.notes.push_back(columns == 3
                                  ? "third column of the file left out"
                                  : "columns 3 to " + std::to_string(columns) + " of the file left out");
      return content;
    }

    bool
    is_no_number(const std::string &field)
    {
      const std::string word = lower(field);
      return word == "nan" || word == "inf" || word == "-nan" || word == "-inf";
    }

    /// Lines of numbers before the points would be points where the heading was not understood: they are
    /// told. One with a "nan" is a faulty point.
    void
    note_headings(FileContent             &content,
                  const std::vector<Line> &lines,
                  const std::size_t        begin,
                  const std::string       &file)
    {
      std::size_t count = 0;
      LeftOut     none;
      for (std::size_t i = 0; i < begin; ++i)
        {
          const auto fields = fields_of(without_comment(lines[i].text, "!#%"));
          if (fields.size() > 1 && (is_no_number(fields[0]) || is_no_number(fields[1])))
            numbers_of(lines[i], 2, file, none); // says so
          count += !fields.empty() && number_of(fields[0]).has_value();
        }
      if (count > 0)
        content.notes.push_back(counted(count, "line") + " of numbers before line " +
                                std::to_string(lines[begin].number) + " taken as heading");
    }

    enum class Format
    {
      simpack,
      miniprof,
      columns
    };

    Format
    format_of(const std::vector<Line> &lines, const std::size_t begin)
    {
      bool is_miniprof = false;
      for (std::size_t i = 0; i < lines.size(); ++i)
        {
          const std::string &text = lines[i].text;
          const std::string  word = lower(without_comment(text, "!"));
          if (word == "header.begin" || word == "spline.begin" || word == "point.begin")
            return Format::simpack;
          const auto equal = text.find('=');
          is_miniprof = is_miniprof || lower(text) == "#minirailprof" || lower(text) == "#miniwheelprof" ||
                        (i < begin && equal != std::string::npos && equal > 0 &&
                         text.find_first_of("!#%") == std::string::npos);
        }
      return is_miniprof ? Format::miniprof : Format::columns;
    }
  } // namespace


  FileContent
  parse_profile_text(const std::string &text, const std::string &file)
  {
    if (text.size() > largest_profile_file)
      throw InputError(file + ": larger than " + std::to_string(largest_profile_file / 1000000) +
                       " MB; a profile file (.prr, .prw, .ban, .whl or two columns) is needed");
    if (text.find('\0') != std::string::npos)
      throw InputError(file +
                       ": not a text file; a profile file (.prr, .prw, .ban, .whl or two columns) is needed");
    std::vector<Line> lines   = lines_of(text);
    const std::size_t begin   = begin_of_points(lines);
    const bool        commas  = take_row_format(lines, begin, file);
    const Format      format  = format_of(lines, begin);
    FileContent       content = format == Format::simpack    ? parse_simpack(lines, file)
                                : format == Format::miniprof ? parse_miniprof(lines, begin, file)
                                                             : parse_columns(lines, begin, file);
    if (format != Format::simpack)
      content.rounding = rounding_of(positions(content.points));
    if (commas)
      content.notes.push_back("decimal commas read as points");
    if (format != Format::simpack && begin < lines.size())
      note_headings(content, lines, begin, file);
    const auto off =
      std::count_if(lines.begin(), lines.end(), [](const Line &line) { return line.text[0] == '"'; });
    if (content.points.empty())
      throw InputError(
        file +
        (off > 0 ? ": " + counted(off, "line") + " switched off by a leading quotation mark, and" : ":") +
        " no points found; a SIMPACK (.prr, .prw), MiniProf (.ban, .whl) or two-column "
        "file with lateral and vertical coordinates is needed");
    return content;
  }
} // namespace wheelrail
