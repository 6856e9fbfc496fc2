#include <wheelrail/base/errors.h>
#include <wheelrail/profiles/profile_text.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace wheelrail
{
  namespace
  {
    /// Columns of X and Y by "ColumnDef=X,Y" or "X,Y,A,C,N".
    std::pair<std::size_t, std::size_t>
    columns_of(const HeaderValues &values)
    {
      if (!values.has("columndef"))
        return {0, 1};
      const Line                    &line  = values.texts.at("columndef");
      const std::vector<std::string> names = fields_of(lower(line.text));
      const auto                     x     = std::find(names.begin(), names.end(), "x"),
                 y                         = std::find(names.begin(), names.end(), "y");
      if (x == names.end() || y == names.end())
        throw InputError(place(values.file, line.number) + "ColumnDef=" + shown(line.text) +
                         ": columns X and Y are needed, such as ColumnDef=X,Y");
      return {x - names.begin(), y - names.begin()};
    }

    /// The header may count one point more or less than there are, and those that were switched off later.
    void
    check_count(FileContent &content, const HeaderValues &values, const std::size_t switched_off)
    {
      const double stated = values.number("xypoints", 0), found = static_cast<double>(content.points.size());
      if (stated <= 0 || stated == found || stated == found + static_cast<double>(switched_off))
        return;
      const Line       &line = values.texts.at("xypoints");
      const std::string what =
        "XYPoints=" + shown(line.text) + ", but the file holds " + counted(content.points.size(), "point");
      if (std::abs(stated - found) > 1)
        throw InputError(place(values.file, line.number) + what + "; it may be cut off, export it again");
      content.notes.push_back(what + ", one " + (stated > found ? "less" : "more") + ": read as they are");
    }
  } // namespace


  FileContent
  parse_miniprof(const std::vector<Line> &lines, const std::size_t begin, const std::string &file)
  {
    FileContent  content;
    HeaderValues values{file, {}};
    LeftOut      left_out;
    std::size_t  free       = 0;
    content.format          = "MiniProf";
    content.down            = true;
    content.metres_per_unit = 1e-3;
    content.gauge_right     = true;
    for (std::size_t i = 0; i < begin; ++i)
      free += !values.take(lines[i]);
    if (free > 0)
      content.notes.push_back(counted(free, "line") + " without \"=\" before the points left out");
    const auto        columns = columns_of(values);
    const std::size_t needed  = std::max(columns.first, columns.second) + 1;
    for (std::size_t i = begin; i < lines.size(); ++i)
      {
        if (is_switched_off(lines[i], left_out) || without_comment(lines[i].text, "!#%").empty())
          continue;
        const std::vector<double> numbers = numbers_of(lines[i], needed, file, left_out);
        add_point(content, {numbers[columns.first], numbers[columns.second]}, lines[i].number, file);
      }
    left_out.tell(content.notes);
    check_count(content, values, left_out.switched_off);
    for (const char *name : {"XOffset", "YOffset", "Tilt"})
      if (values.number(lower(name), 0) != 0)
        content.notes.push_back(std::string(name) + " of the file is taken as applied already");
    return content;
  }
} // namespace wheelrail
