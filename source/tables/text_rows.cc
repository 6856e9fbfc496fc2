#include <wheelrail/base/errors.h>
#include <wheelrail/base/format_text.h>
#include <wheelrail/base/read_file.h>
#include <wheelrail/tables/text_rows.h>

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
  without_comment(const std::string &line, const char *marks)
  {
    return trimmed(line.substr(0, line.find_first_of(marks)));
  }

  std::string
  place(const std::string &file, const unsigned int line)
  {
    return file + ":" + std::to_string(line) + ": ";
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


  namespace
  {
    /// The cells of a row as they are written, quotation marks left out.
    std::vector<std::string>
    written_cells(const std::string &row, const char separator)
    {
      std::vector<std::string> cells{""};
      bool                     quoted = false;
      for (const char c : trimmed(row))
        if (c == '"')
          quoted = !quoted;
        else if (quoted || (separator == ' ' ? c != ' ' && c != '\t' : c != separator))
          cells.back() += c;
        else if (separator != ' ' || !cells.back().empty()) // blanks in a row part two cells only
          cells.emplace_back();
      for (std::string &cell : cells)
        cell = trimmed(cell);
      return cells;
    }

    /// A number whose decimal mark is a comma, "-0,12", with a point; nothing for other texts.
    std::optional<std::string>
    with_point(std::string number)
    {
      const std::size_t comma = number.find(',');
      if (comma == std::string::npos || comma + 1 == number.size() || number.find('.') != std::string::npos)
        return {};
      number[comma] = '.';
      if (!number_of(number))
        return {};
      return number;
    }

    /// How a cell writes its number: ',' or '.' for its decimal mark, '0' for none, ' ' where it is no
    /// number.
    char
    mark_of(std::string cell, const bool words)
    {
      if (const std::size_t end = cell.find_first_of(" \t"); words && end != std::string::npos)
        {
          const std::string rest = trimmed(cell.substr(end));
          if (number_of(rest.substr(0, rest.find_first_of(" \t,;"))))
            return ' ';
          cell.resize(end);
        }
      if (with_point(cell))
        return ',';
      return !number_of(cell) ? ' ' : cell.find('.') != std::string::npos ? '.' : '0';
    }
  } // namespace


  std::vector<std::string>
  cells_of(const std::string &row, const RowFormat &format, const std::size_t most)
  {
    std::vector<std::string> cells = written_cells(row, format.separator);
    while (cells.size() > std::max<std::size_t>(1, most) && cells.back().empty())
      cells.pop_back();
    if (format.decimal_comma)
      for (std::string &cell : cells)
        {
          const std::size_t end = cell.find_first_of(" \t");
          if (const auto number = with_point(cell.substr(0, end)))
            cell = *number + (end == std::string::npos ? "" : cell.substr(end));
        }
    return cells;
  }


  namespace
  {
    /// What a separator makes of rows.
    struct Judged
    {
      std::size_t fits = 0, commas = 0, points = 0; ///< rows
      const Line *first_comma = nullptr, *first_point = nullptr;
      bool        sure = false; ///< a comma that can be no separator of thousands, as in 0,5 or 1,25
    };

    bool
    may_be_thousands(const std::string &cell)
    {
      const std::size_t first = cell.find_first_of("0123456789"), comma = cell.find(',');
      return comma > first && comma - first <= 3 && cell[first] != '0' && cell.size() == comma + 4;
    }

    Judged
    judged(const std::vector<Line>        &rows,
           const std::vector<std::size_t> &numbers,
           const std::size_t               cells,
           const bool                      words,
           const char                      separator)
    {
      Judged all;
      for (const Line &row : rows)
        {
          const std::vector<std::string> in = cells_of(row.text, {separator, false}, cells);
          bool fits = cells == 0 || in.size() == cells, comma = false, point = false;
          for (const std::size_t k : numbers)
            {
              const std::string cell = k < in.size() ? in[k] : "";
              const char        mark = mark_of(cell, words);
              const bool        both = mark == ' ' && cell.find(',') != std::string::npos &&
                                cell.find('.') != std::string::npos; // thousands are separated, too
              fits     = fits && mark != ' ';
              comma    = comma || mark == ',' || both;
              point    = point || mark == '.' || both;
              all.sure = all.sure || (mark == ',' && !may_be_thousands(cell));
            }
          all.fits += fits;
          all.commas += comma;
          all.points += point;
          if (comma && !all.first_comma)
            all.first_comma = &row;
          if (point && !all.first_point)
            all.first_point = &row;
        }
      return all;
    }
  } // namespace


  RowFormat
  row_format(const std::vector<Line>        &rows,
             const std::vector<std::size_t> &numbers,
             const std::size_t               cells,
             const bool                      words,
             const std::string              &file)
  {
    char   separator = ' ';
    Judged best;
    for (const char other : {';', '\t', ',', ' '})
      if (const Judged here = judged(rows, numbers, cells, words, other); here.fits > best.fits)
        {
          best      = here;
          separator = other;
          if (best.fits == rows.size())
            break;
        }
    if (best.fits == 0 && !rows.empty()) // what is wrong is told with the separator that stands there
      {
        const std::size_t at = rows.front().text.find_first_of(";\t,");
        separator            = at == std::string::npos ? (cells == 1 ? ';' : ' ') : rows.front().text[at];
        best                 = judged(rows, numbers, cells, words, separator);
      }
    const auto fail = [&](const Line &row, const std::string &why) {
      throw InputError(place(file, row.number) + "\"" + shown_text(row.text, 40) + "\" " + why +
                       "; write numbers with one decimal mark and without separators of thousands");
    };
    if (best.commas > 0 && best.points > 0)
      fail(best.points < best.commas ? *best.first_point : *best.first_comma,
           "has another decimal mark than other rows");
    // decimals of three digits throughout, or whole numbers of which some have thousands
    if (best.commas > 0 && !best.sure && (separator != ';' || best.commas < rows.size()))
      fail(*best.first_comma, "has commas between digits that may be decimal marks or part thousands");
    return {separator, best.commas > 0};
  }
} // namespace wheelrail
