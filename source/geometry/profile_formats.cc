#include <wheelrail/base/errors.h>
#include <wheelrail/geometry/profile_text.h>

#include <algorithm>
#include <cmath>

namespace wheelrail
{
  namespace
  {
    // --- MiniProf --------------------------------------------------------------------------------

    /// Columns of X and Y by "ColumnDef=X,Y" or "X,Y,A,C,N".
    std::pair<std::size_t, std::size_t>
    miniprof_columns(const HeaderValues &values)
    {
      const auto found = values.texts.find("columndef");
      if (found == values.texts.end())
        return {0, 1};
      const std::vector<std::string> names = fields_of(lower(found->second.text));
      const auto                     x     = std::find(names.begin(), names.end(), "x"),
                 y                         = std::find(names.begin(), names.end(), "y");
      if (x == names.end() || y == names.end())
        throw InputError(place(values.file, found->second.number) + "ColumnDef=" + shown(found->second.text) +
                         ": columns X and Y are needed, such as ColumnDef=X,Y");
      return {x - names.begin(), y - names.begin()};
    }

    FileContent
    parse_miniprof(const std::vector<Line> &lines, const std::string &file)
    {
      FileContent  content;
      HeaderValues values{file, {}};
      content.format          = "MiniProf";
      content.metres_per_unit = 1e-3;
      content.gauge_right     = true;
      std::pair<std::size_t, std::size_t> columns;
      for (const Line &line : lines)
        {
          if (!content.points.empty() || !values.take(line))
            {
              if (content.points.empty())
                columns = miniprof_columns(values);
              const std::vector<double> numbers =
                numbers_of(line, std::max(columns.first, columns.second) + 1, file);
              add_point(content, {numbers[columns.first], numbers[columns.second]}, line.number, file);
            }
        }
      const double stated = values.number("xypoints", 0);
      if (stated > 0 && stated != static_cast<double>(content.points.size()))
        throw InputError(place(file, values.texts["xypoints"].number) +
                         "XYPoints=" + shown(values.texts["xypoints"].text) + ", but the file holds " +
                         counted(content.points.size(), "point") + "; it may be cut off, export it again");
      for (const char *name : {"XOffset", "YOffset", "Tilt"})
        if (values.number(lower(name), 0) != 0)
          content.notes.push_back(std::string(name) + " of the file is taken as applied already");
      return content;
    }

    // --- two columns -----------------------------------------------------------------------------

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

    FileContent
    parse_columns(const std::vector<Line> &lines, const std::string &file)
    {
      FileContent content;
      content.format       = "two columns";
      unsigned int columns = 0, headings = 0;
      for (const Line &whole : lines)
        {
          const Line line{without_comment(whole.text, "!#%"), whole.number};
          if (content.points.empty())
            if (const double unit = unit_in(whole.text); unit > 0 && content.metres_per_unit == 0)
              content.metres_per_unit = unit;
          if (line.text.empty())
            continue;
          const std::vector<std::string> fields = fields_of(line.text);
          if (content.points.empty() && !fields.empty() && !number_of(fields[0]) && ++headings <= 20)
            continue;
          const std::vector<double> numbers = numbers_of(line, 2, file);
          if (fields.size() > 3)
            throw InputError(
              place(file, line.number) + shown(line.text) + " holds " + std::to_string(fields.size()) +
              " columns; two are accepted, lateral and vertical coordinate, with a point as decimal "
              "mark (a third one is left out)");
          if (columns != 0 && columns != fields.size())
            throw InputError(place(file, line.number) + shown(line.text) + " holds " +
                             std::to_string(fields.size()) + " columns, the lines before " +
                             std::to_string(columns) + "; write two in every line");
          columns = static_cast<unsigned int>(fields.size());
          add_point(content, {numbers[0], numbers[1]}, line.number, file);
        }
      if (columns == 3)
        content.notes.push_back("third column of the file left out");
      return content;
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
    const std::vector<Line> lines = lines_of(text);

    bool is_simpack = false, is_miniprof = false, number_seen = false;
    for (const Line &line : lines)
      {
        const std::string word = lower(without_comment(line.text, "!"));
        is_simpack = is_simpack || word == "header.begin" || word == "spline.begin" || word == "point.begin";
        const auto fields = fields_of(without_comment(line.text, "!#%"));
        number_seen       = number_seen || (!fields.empty() && number_of(fields[0]));
        const auto equal  = line.text.find('=');
        is_miniprof       = is_miniprof || (!number_seen && equal != std::string::npos && equal > 0 &&
                                      line.text.find_first_of("!#%") == std::string::npos);
      }
    FileContent content = is_simpack    ? parse_simpack(lines, file)
                          : is_miniprof ? parse_miniprof(lines, file)
                                        : parse_columns(lines, file);
    if (content.points.empty())
      throw InputError(file +
                       ": no points found; a SIMPACK (.prr, .prw), MiniProf (.ban, .whl) or two-column "
                       "file with lateral and vertical coordinates is needed");
    return content;
  }
} // namespace wheelrail
