#include <wheelrail/base/choices.h>
#include <wheelrail/base/errors.h>
#include <wheelrail/base/format_text.h>
#include <wheelrail/base/read_file.h>
#include <wheelrail/tables/table.h>
#include <wheelrail/tables/table_head.h>
#include <wheelrail/tables/text_rows.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>

namespace wheelrail
{
  namespace
  {
    using Cells = std::vector<std::string>;

    const std::string no_rows =
      ": no rows; such a table has a first line with names and units, and rows of numbers";

    /// The lines of a file without remarks.
    std::vector<Line>
    lines_of_file(const std::string &path, const std::string &purpose, const char *remarks)
    {
      if (const std::string other = other_than_a_file(path); !other.empty())
        throw InputError(path + ": " + other + "; " + purpose);
      if (!std::filesystem::exists(path))
        throw InputError(path + ": no such file; " + purpose);
      std::string text;
      try
        {
          text = read_whole_file(path);
        }
      catch (const RunError &error)
        {
          throw InputError(error.what());
        }
      if (text.find('\0') != std::string::npos)
        throw InputError(path + ": no text in UTF-8, as a spreadsheet saves \"CSV\"; " + purpose);
      std::vector<Line> lines;
      for (const Line &line : lines_of(text))
        if (line.number == 1 && lower(line.text).find("sep=") == 0)
          continue; // a spreadsheet's word for the separator, which rows tell themselves
        else if (const std::string rest = without_comment(line.text, remarks); !rest.empty())
          lines.push_back({rest, line.number});
      return lines;
    }

    /// A number, also as a fraction, "1/40".
    std::optional<double>
    number_in(const std::string &cell)
    {
      if (const auto number = number_of(cell))
        return number;
      try
        {
          return parse_quantity(cell, Dimension::none);
        }
      catch (const InputError &)
        {
          return std::nullopt;
        }
    }

    /// Reads one file.
    class Reader
    {
    public:
      Reader(const std::string &path, const std::vector<TableColumn> &known, const TableOptions &options)
        : path_(path)
        , known_(known)
        , options_(options)
      {
        for (const TableColumn &column : known_)
          names_.push_back(plain_name(column.name));
      }

      Table
      read();

    private:
      /// A column that is read: where it stands in a row, what turns it into SI.
      struct Column
      {
        std::size_t        cell;
        const TableColumn *of;
        double             factor;
      };

      [[noreturn]] void
      fail(const std::string &why) const
      {
        throw InputError(place(path_, line_) + why);
      }
      /// The head of a cell, under its name here.
      TableHead
      renamed(const std::string &cell) const;
      /// Gives a head the unit that the file says, which must not differ from that of the table of names.
      void
      take_unit(TableHead &head, const std::string &unit) const;
      /// Units of a second line, where this is one.
      bool
      take_units(const std::string &line);
      /// Whether a name is a known one but for a letter or two: then it is one that was misspelt.
      bool
      resembles_known(const std::string &name) const;
      void
      settle_columns();
      double
      unit_factor(const TableHead &head, const TableColumn &column) const;
      void
      take_row(const std::string &line, const RowFormat &format);
      double
      value_of(const Column &column, const std::string &cell) const;

      std::string                     path_;
      const std::vector<TableColumn> &known_;
      const TableOptions             &options_;
      Cells                           names_;
      unsigned int                    line_ = 0;
      std::vector<TableHead>          heads_;
      std::vector<Column>             columns_;
      Table                           table_;
    };

    TableHead
    Reader::renamed(const std::string &cell) const
    {
      TableHead own = head_of(cell, known_);
      for (const std::string &name : {cell, trimmed(cell.substr(0, cell.find_first_of("[(")))})
        if (const auto found = options_.names.find(name); found != options_.names.end())
          {
            std::string  name_here = found->second;
            const double factor    = take_factor(name_here);
            TableHead    here      = head_of(name_here, known_);
            here.cell              = cell;
            here.factor            = factor;
            if (own.has_unit)
              take_unit(here, own.unit);
            return here;
          }
      return own;
    }

    void
    Reader::take_unit(TableHead &head, const std::string &unit) const
    {
      const auto known = std::find(names_.begin(), names_.end(), head.name);
      if (head.has_unit && known != names_.end())
        {
          const Dimension dimension = known_[known - names_.begin()].dimension;
          const auto      one = factor_of(unit, dimension), other = factor_of(head.unit, dimension);
          if (one && other && *one != *other)
            fail("column \"" + shown_text(head.cell, 40) + "\" is in " + shown_text(unit, 40) +
                 " here and in " + shown_text(head.unit, 40) +
                 " in the table of names; leave one of them out");
          if (!one) // not a unit: words that the table of names replaces
            return;
        }
      head.unit     = unit;
      head.has_unit = true;
    }

    bool
    Reader::take_units(const std::string &line)
    {
      const Cells cells = heads_of(line);
      const bool  bare  = std::none_of(heads_.begin(), heads_.end(), [&](const TableHead &head) {
        return head_of(head.cell, known_).has_unit;
      });
      if (!bare || cells.size() != heads_.size() ||
          std::any_of(cells.begin(), cells.end(), [](const auto &cell) {
            return number_in(cells_of(cell, {';', true})[0]) && cell != "1";
          }))
        return false;
      for (std::size_t k = 0; k < cells.size(); ++k)
        {
          const bool brackets = cells[k].size() > 1 && cells[k].find_first_of("[(") == 0;
          take_unit(heads_[k], brackets ? trimmed(cells[k].substr(1, cells[k].size() - 2)) : cells[k]);
        }
      return true;
    }

    bool
    Reader::resembles_known(const std::string &name) const
    {
      const unsigned int most = name.size() <= 5 ? 1 : 2; // of short names hardly a letter is left otherwise
      return std::any_of(names_.begin(), names_.end(), [&](const std::string &known) {
        return edit_distance(known, name) <= most;
      });
    }

    double
    Reader::unit_factor(const TableHead &head, const TableColumn &column) const
    {
      const std::string begin = "column \"" + shown_text(head.cell, 40) + "\"";
      if (!head.has_unit && column.dimension != Dimension::none)
        {
          const std::string units = dimension_units(column.dimension);
          fail(begin + " has no unit; write it in brackets, such as \"" + head.name + " [" +
               units.substr(0, units.find(',')) + "]\"");
        }
      if (const auto factor = factor_of(head.unit, column.dimension))
        return *factor;
      if (column.dimension == Dimension::none)
        fail(begin + ": \"" + shown_text(head.unit, 40) + "\" is no unit of a " + head.name +
             "; %, or 1 is accepted");
      try
        {
          return parse_quantity("1 " + head.unit, column.dimension);
        }
      catch (const InputError &error)
        {
          fail(begin + ": " + error.what());
        }
    }

    void
    Reader::settle_columns()
    {
      Cells       shown;
      std::string example, left_out;
      for (const TableColumn &column : known_)
        {
          shown.push_back(column.name);
          const std::string units = dimension_units(column.dimension);
          if (example.empty() && column.dimension != Dimension::none)
            example = ", each with its unit in brackets, such as \"" + shown.back() + " [" +
                      units.substr(0, units.find(',')) + "]\"";
        }
      const std::string there = "; there are " + join_choices(shown, "and") + example;
      const std::string renaming =
        *options_.renaming
          ? std::string("; a table of names says what they are called here (") + options_.renaming + ")"
          : "";
      for (std::size_t k = 0; k < heads_.size(); ++k)
        {
          const TableHead &head  = heads_[k];
          const auto       known = std::find(names_.begin(), names_.end(), head.name);
          if (known == names_.end())
            {
              if (options_.leaves && !resembles_known(head.name))
                {
                  left_out += (left_out.empty() ? "\"" : ", \"") + shown_text(head.cell, 40) + "\"";
                  continue;
                }
              fail("column \"" + shown_text(head.cell, 40) + "\" is not known" + perhaps(head.name, names_) +
                   there);
            }
          const TableColumn &column = known_[known - names_.begin()];
          if (std::any_of(
                columns_.begin(), columns_.end(), [&](const Column &other) { return other.of == &column; }))
            fail("two columns of " + head.name + "; leave one out");
          columns_.push_back({k, &column, head.factor * unit_factor(head, column)});
          table_.known.push_back(known - names_.begin());
        }
      for (std::size_t k = 0; k < known_.size(); ++k)
        if (known_[k].needed && std::find(table_.known.begin(), table_.known.end(), k) == table_.known.end())
          fail("no column " + shown[k] + "; " + options_.purpose);
      if (columns_.empty())
        fail("no column is known" + there + renaming);
      if (!left_out.empty())
        table_.notes.push_back(path_ + ": columns that are not used: " + left_out + renaming);
      table_.columns.resize(columns_.size());
    }

    double
    Reader::value_of(const Column &column, const std::string &cell) const
    {
      const std::string name = column.of->name;
      if (cell.empty())
        fail("no value of " + name + "; rows cannot have gaps: fill it or leave the column out");
      const auto number = number_in(cell);
      if (!number)
        fail("\"" + shown_text(cell, 40) + "\" of " + name +
             " is not a number; units belong in the first line");
      const double value = column.factor * *number;
      if ((value != 0 && std::abs(value) < column.of->least_amount) ||
          value < column.of->least * (column.of->least < 0 ? 1 + 1e-12 : 1 - 1e-12) ||
          value > column.of->most * (1 + 1e-12))
        fail(name + " = " + shown_text(cell, 40) + " is out of range; " + column.of->range +
             " is accepted, in the unit of the first line");
      return value;
    }

    void
    Reader::take_row(const std::string &line, const RowFormat &format)
    {
      const Cells cells = cells_of(line, format, heads_.size());
      if (cells.size() != heads_.size())
        fail("a row of " + std::to_string(cells.size()) + " values, the first line names " +
             std::to_string(heads_.size()) + " columns");
      for (std::size_t k = 0; k < columns_.size(); ++k)
        {
          const Column      &of    = columns_[k];
          const std::string &cell  = cells[of.cell];
          const double       value = value_of(of, cell);
          auto              &rows  = table_.columns[k];
          if (of.of->grows && !rows.empty() && !(value > rows.back()))
            fail(std::string(of.of->name) + " = " + shown_text(cell, 40) +
                 (value == rows.back() ? " is in the row before, too; leave one of them out"
                                       : " is less than in the row before; sort the rows"));
          rows.push_back(value);
        }
      table_.lines.push_back(line_);
    }

    Table
    Reader::read()
    {
      std::vector<Line> lines = lines_of_file(path_, options_.purpose, options_.remarks);
      if (lines.empty())
        throw InputError(path_ + no_rows);
      line_                   = lines.front().number;
      const std::string first = lines.front().text;
      const bool numbers = *options_.otherwise && number_of(first.substr(0, first.find_first_of(" \t,;")));
      const bool one     = std::count(names_.begin(), names_.end(), plain_name(first)) > 0;
      for (const std::string &cell : numbers ? heads_of(options_.otherwise)
                                     : one   ? Cells{first}
                                             : heads_of(first))
        heads_.push_back(renamed(cell));
      std::size_t begin = !numbers;
      begin += !numbers && lines.size() > 1 && take_units(lines[1].text);
      settle_columns();
      lines.erase(lines.begin(), lines.begin() + begin);
      if (lines.empty())
        throw InputError(path_ + no_rows);
      std::vector<std::size_t> cells;
      for (const Column &column : columns_)
        cells.push_back(column.cell);
      const RowFormat format = row_format(lines, cells, heads_.size(), false, path_);
      for (const Line &line : lines)
        {
          line_ = line.number;
          take_row(line.text, format);
        }
      return table_;
    }
  } // namespace


  const std::vector<double> *
  Table::find(const std::size_t of) const
  {
    const auto at = std::find(known.begin(), known.end(), of);
    return at == known.end() ? nullptr : &columns[at - known.begin()];
  }


  Table
  read_table(const std::string &path, const std::vector<TableColumn> &known, const TableOptions &options)
  {
    return Reader(path, known, options).read();
  }


  ColumnNames
  read_column_names(const std::string &path, const std::vector<TableColumn> &known)
  {
    ColumnNames names;
    Cells       here;
    for (const TableColumn &column : known)
      here.push_back(plain_name(column.name));
    for (const Line &line :
         lines_of_file(path, "--columns needs a table of names: the name in the rows, the name here", "#"))
      {
        const Cells cells = heads_of(line.text);
        if (cells.size() != 2 || cells[0].empty() || cells[1].empty())
          throw InputError(
            place(path, line.number) +
            "a line holds two names with a comma, semicolon or tab between: that in the rows and that "
            "here, such as \"y_ws;lateral shift [mm]\"");
        std::string name = cells[1];
        take_factor(name);
        name = head_of(name, known).name;
        if (std::find(here.begin(), here.end(), name) == here.end())
          throw InputError(place(path, line.number) + "\"" + shown_text(name, 40) + "\" is no column" +
                           perhaps(name, here) + "; there are " + join_choices(here, "and"));
        if (!names.emplace(cells[0], cells[1]).second)
          throw InputError(place(path, line.number) + "\"" + shown_text(cells[0], 40) +
                           "\" is in a line before, too; leave one of them out");
      }
    return names;
  }
} // namespace wheelrail
