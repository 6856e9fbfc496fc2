#include <wheelrail/base/errors.h>
#include <wheelrail/tables/table_head.h>
#include <wheelrail/tables/text_rows.h>

#include <algorithm>
#include <utility>

namespace wheelrail
{
  std::vector<std::string>
  heads_of(const std::string &line)
  {
    for (const char separator : {';', '\t', ','})
      if (std::vector<std::string> cells = cells_of(line, {separator, false}); cells.size() > 1)
        {
          const bool commas_too =
            separator == '\t' && std::all_of(cells.begin(), cells.end() - 1, [](auto &c) {
              return !c.empty() && c.back() == ',';
            });
          if (!commas_too)
            return cells;
        }
    if (line.find_first_of("[(\"") == std::string::npos)
      return cells_of(line, {' ', false});
    std::vector<std::string> cells;
    for (std::size_t begin = 0; begin < line.size();)
      {
        const std::size_t open = line.find_first_of("[(", begin);
        const std::size_t end =
          open == std::string::npos ? open : line.find(line[open] == '[' ? ']' : ')', open);
        cells.push_back(
          cells_of(line.substr(begin, end == std::string::npos ? end : end + 1 - begin), {';', false})[0]);
        begin = end == std::string::npos ? line.size() : line.find_first_not_of(" \t", end + 1);
      }
    return cells;
  }

  std::optional<double>
  factor_of(std::string unit, const Dimension dimension)
  {
    if (dimension == Dimension::none)
      return unit == "%"                                  ? std::optional<double>(0.01)
             : unit.empty() || unit == "1" || unit == "-" ? std::optional<double>(1)
                                                          : std::nullopt;
    for (std::size_t k = 0; k < unit.size(); ++k)
      if (k == 0 || (unit[k - 1] != '\xC2' && unit[k - 1] != '\xCE'))
        unit[k] = unit[k] == '\xB5' ? 'u' : unit[k] == '\xB2' ? '2' : unit[k];
    if (unit == "kmh" || unit == "kph")
      unit = "km/h";
    if (const std::size_t per = unit.find(" per "); per != std::string::npos)
      unit.replace(per, 5, "/");
    for (const char between : {' ', '/'})
      {
        std::string other = unit;
        std::replace(other.begin(), other.end(), ' ', between);
        try
          {
            return parse_quantity("1 " + other, dimension);
          }
        catch (const InputError &)
          {
          }
      }
    return {};
  }

  double
  take_factor(std::string &name)
  {
    double factor = 1;
    if (const std::size_t times = name.find('*'); times != std::string::npos)
      if (const auto number = number_of(trimmed(name.substr(0, times))); number && *number != 0)
        {
          factor = *number;
          name   = trimmed(name.substr(times + 1));
        }
    if (!name.empty() && name.front() == '-')
      {
        factor = -factor;
        name   = trimmed(name.substr(1));
      }
    return factor;
  }

  std::string
  plain_name(const std::string &text)
  {
    std::string name = lower(trimmed(text));
    std::replace(name.begin(), name.end(), '_', ' ');
    return name;
  }

  TableHead
  head_of(const std::string &cell, const std::vector<TableColumn> &known)
  {
    TableHead head;
    head.cell = cell;
    head.name = plain_name(cell);
    for (const auto &[open, close] : {std::make_pair('[', ']'), {'(', ')'}})
      if (const std::size_t begin = cell.find(open), end = cell.rfind(close);
          begin != std::string::npos && end != std::string::npos && end > begin)
        {
          head.name     = plain_name(cell.substr(0, begin));
          head.unit     = trimmed(cell.substr(begin + 1, end - begin - 1));
          head.has_unit = true;
          return head;
        }
    std::size_t longest = 0;
    for (const TableColumn &column : known) // "load right_kN" is one of load right
      {
        const std::string name = plain_name(column.name);
        if (name.size() <= longest || head.name.size() <= name.size() ||
            head.name.compare(0, name.size(), name) != 0 ||
            std::string(" ,/").find(head.name[name.size()]) == std::string::npos)
          continue;
        std::string unit = trimmed(cell).substr(name.size());
        std::replace(unit.begin(), unit.end(), '_', ' ');
        unit = unit.substr(std::min(unit.size(), unit.find_first_not_of(" ,/")));
        if (unit.compare(0, 3, "in ") == 0)
          unit = trimmed(unit.substr(3));
        if (unit.empty() || !factor_of(unit, column.dimension))
          continue;
        longest       = name.size();
        head.unit     = unit;
        head.has_unit = true;
      }
    if (head.has_unit)
      head.name.resize(longest);
    return head;
  }
} // namespace wheelrail
