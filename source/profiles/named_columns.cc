#include <wheelrail/base/errors.h>
#include <wheelrail/base/read_file.h>
#include <wheelrail/profiles/named_columns.h>
#include <wheelrail/profiles/profile_text.h>

#include <optional>

namespace wheelrail
{
  namespace
  {
    std::string
    text_of_table(const std::string &path)
    {
      try
        {
          return read_whole_file(path);
        }
      catch (const RunError &error)
        {
          throw InputError(error.what());
        }
    }

    /// Where a column stands in the lines of a table, and its factor to SI; 0: it lacks.
    struct FoundColumn
    {
      std::size_t place = 0;
      double      unit  = 0;
    };

    /// "along_mm (or _m, _um)".
    std::string
    names_of(const NamedColumn &column)
    {
      std::string first, others;
      for (const auto &[ending, unit] : column.units)
        if (first.empty())
          first = column.quantity + ending;
        else
          others += (others.empty() ? "" : ", ") + ending;
      return others.empty() ? first : first + " (or " + others + ")";
    }

    std::vector<FoundColumn>
    find_columns(const std::vector<std::string> &names,
                 const std::vector<NamedColumn> &columns,
                 const std::string              &where,
                 const std::string              &accepted)
    {
      std::vector<FoundColumn> found(columns.size());
      for (std::size_t c = 0; c < columns.size(); ++c)
        {
          for (std::size_t k = 0; k < names.size(); ++k)
            if (const double unit = unit_of(lower(names[k]), columns[c]); unit > 0)
              found[c] = {k, unit};
          if (columns[c].needed && found[c].unit == 0)
            throw InputError(where + "no column " + names_of(columns[c]) + accepted);
        }
      return found;
    }
  } // namespace


  std::vector<std::pair<std::string, double>>
  length_units()
  {
    return {{"_mm", 1e-3}, {"_m", 1.}, {"_um", 1e-6}};
  }


  double
  unit_of(const std::string &name, const NamedColumn &column)
  {
    for (const auto &[ending, unit] : column.units)
      if (name == lower(column.quantity + ending))
        return unit;
    return 0;
  }


  NamedTable
  read_named_columns(const std::string              &path,
                     const std::vector<NamedColumn> &columns,
                     const std::string              &accepted)
  {
    NamedTable               table;
    std::vector<FoundColumn> found;
    for (const Line &line : lines_of(text_of_table(path)))
      {
        const std::string text = trimmed(without_comment(line.text, "#%!"));
        if (text.empty())
          continue;
        const std::vector<std::string> fields = fields_of(text);
        if (found.empty())
          {
            found = find_columns(fields, columns, place(path, line.number), accepted);
            for (const FoundColumn &column : found)
              table.has.push_back(column.unit > 0);
            continue;
          }
        NamedRow row{std::vector<double>(columns.size(), 0.), line.number};
        for (std::size_t c = 0; c < columns.size(); ++c)
          if (found[c].unit > 0)
            {
              const auto number =
                found[c].place < fields.size() ? number_of(fields[found[c].place]) : std::nullopt;
              if (!number)
                throw InputError(place(path, line.number) + shown(text) + ": no number for " +
                                 columns[c].quantity + accepted);
              row.value[c] = found[c].unit * *number;
            }
        table.rows.push_back(row);
      }
    if (found.empty())
      throw InputError(path + ": empty" + accepted);
    return table;
  }
} // namespace wheelrail
