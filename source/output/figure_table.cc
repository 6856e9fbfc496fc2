#include <wheelrail/base/format_text.h>
#include <wheelrail/output/figure_table.h>
#include <wheelrail/output/figures.h>
#include <wheelrail/output/hdf5_file.h>
#include <wheelrail/output/replace_file.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

namespace wheelrail
{
  std::string
  unit_of(const std::string &key)
  {
    for (const Figure &figure : all_figures())
      for (const char *tail : {"", "_low", "_high"})
        if (key == figure.key(tail))
          return figure.si_unit();
    return "1";
  }


  void
  FigureTable::add(const std::string &key, const std::string &unit, std::vector<double> values)
  {
    keys.push_back(key);
    units.push_back(unit);
    columns.push_back(std::move(values));
  }


  void
  FigureTable::add_columns(const std::string &keys_and_units)
  {
    for (const std::string &one : split_list(keys_and_units, ','))
      add(one.substr(0, one.find(' ')), one.substr(one.find(' ') + 1), {});
  }


  void
  FigureTable::add_row(const std::vector<double> &values)
  {
    for (std::size_t k = 0; k < keys.size(); ++k)
      columns[k].push_back(values.at(k));
  }


  void
  FigureTable::add_figures(const std::vector<std::string> &wanted,
                           const std::vector<Summary>     &summaries,
                           const std::string              &before)
  {
    for (const std::string &key : wanted)
      {
        std::vector<double> values;
        for (const Summary &summary : summaries)
          values.push_back(get_figure(summary, before + key));
        if (std::any_of(values.begin(), values.end(), [](const double v) { return std::isfinite(v); }))
          add(before + key, unit_of(key), std::move(values));
      }
  }


  const std::vector<double> *
  FigureTable::find(const std::string &key) const
  {
    const auto at = std::find(keys.begin(), keys.end(), key);
    return at == keys.end() ? nullptr : &columns[at - keys.begin()];
  }


  std::size_t
  FigureTable::rows() const
  {
    return columns.empty() ? 0 : columns.front().size();
  }


  std::string
  FigureTable::as_csv() const
  {
    std::string text;
    for (std::size_t k = 0; k < keys.size(); ++k)
      text += (k > 0 ? "," : "") + keys[k];
    text += '\n';
    for (std::size_t row = 0; row < rows(); ++row)
      {
        for (std::size_t k = 0; k < keys.size(); ++k)
          text += (k > 0 ? "," : "") +
                  (std::isfinite(columns[k][row]) ? wheelrail::text("%.9g", columns[k][row]) : "");
        text += '\n';
      }
    return text;
  }


  void
  FigureTable::write_csv(const std::string &path) const
  {
    replace_file(path, as_csv());
  }


  void
  FigureTable::write_hdf5(const std::string &path) const
  {
    write_history({keys, units, columns}, path);
  }
} // namespace wheelrail
