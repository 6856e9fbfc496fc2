#include <wheelrail/base/choices.h>
#include <wheelrail/base/errors.h>
#include <wheelrail/base/file_kind.h>
#include <wheelrail/base/quantity.h>
#include <wheelrail/base/read_file.h>
#include <wheelrail/base/shown_text.h>
#include <wheelrail/base/split_list.h>
#include <wheelrail/input/row_reader.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <optional>
#include <sstream>
#include <vector>

namespace wheelrail
{
  namespace
  {
    using Q     = MotionQuantity;
    using Cells = std::vector<std::string>;

    std::string
    trimmed(const std::string &text)
    {
      const std::size_t first = text.find_first_not_of(" \t\r\""), last = text.find_last_not_of(" \t\r\"");
      return first == std::string::npos ? "" : text.substr(first, last - first + 1);
    }

    char
    separator_of(const std::string &line)
    {
      return line.find(';') != std::string::npos ? ';' : line.find(',') != std::string::npos ? ',' : '\t';
    }

    Cells
    cells_of(const std::string &line, const char separator)
    {
      Cells cells = split_list(line, separator);
      for (std::string &cell : cells)
        cell = trimmed(cell);
      return cells;
    }

    /// A number with a decimal comma as one with a point; other texts as they are.
    std::string
    with_point(std::string text)
    {
      const std::size_t comma = text.find(',');
      const auto        digit = [&](const std::size_t k) {
        return k < text.size() && std::isdigit(static_cast<unsigned char>(text[k]));
      };
      if (comma != std::string::npos && comma > 0 && digit(comma - 1) && digit(comma + 1) &&
          text.find(',', comma + 1) == std::string::npos)
        text[comma] = '.';
      return text;
    }

    std::optional<double>
    number_in(const std::string &cell)
    {
      try
        {
          return parse_quantity(cell, Dimension::none);
        }
      catch (const InputError &)
        {
          return std::nullopt;
        }
    }

    /// Lines of a file that are not empty, without remarks, each with its number.
    std::vector<std::pair<int, std::string>>
    lines_of(const std::string &path, const std::string &purpose)
    {
      if (const std::string other = other_than_a_file(path); !other.empty())
        throw InputError(path + ": " + other + "; " + purpose);
      if (!std::filesystem::exists(path))
        throw InputError(path + ": no such file; " + purpose);
      std::vector<std::pair<int, std::string>> lines;
      std::istringstream                       text(read_whole_file(path));
      int                                      number = 0;
      for (std::string line; std::getline(text, line);)
        {
          ++number;
          line = line.substr(0, line.find('#'));
          if (number == 1 && line.compare(0, 3, "\xEF\xBB\xBF") == 0)
            line = line.substr(3);
          if (!trimmed(line).empty())
            lines.emplace_back(number, line);
        }
      return lines;
    }

    /// A cell of the first line: "load [kN]".
    struct Head
    {
      std::string cell; ///< as it stands
      std::string name;
      std::string unit;
      bool        has_unit = false;
      double      sign     = 1;
    };

    Head
    head_of(const std::string &cell)
    {
      Head              head;
      const std::size_t open = cell.find_first_of("[("), close = cell.find_last_of("])");
      head.cell = cell;
      head.name = trimmed(cell.substr(0, open));
      std::replace(head.name.begin(), head.name.end(), '_', ' ');
      head.has_unit = open != std::string::npos && close != std::string::npos && close > open;
      if (head.has_unit)
        head.unit = trimmed(cell.substr(open + 1, close - open - 1));
      return head;
    }

    /// Reads one file.
    class Reader
    {
    public:
      Reader(const std::string &path, const MotionColumns &known, const RowOptions &options)
        : path_(path)
        , known_(known)
        , options_(options)
      {
        for (const MotionColumn &column : known_)
          names_.push_back(column.name);
      }

      MotionFile
      read();

    private:
      /// A column that is read: where it stands in a row, what it holds, what turns it into SI.
      struct Column
      {
        std::size_t         cell;
        const MotionColumn *of;
        double              factor;
      };

      [[noreturn]] void
      fail(const std::string &why) const
      {
        throw InputError(path_ + ":" + std::to_string(line_) + ": " + why);
      }
      /// The head of a cell, under its name here.
      Head
      renamed(const std::string &cell) const;
      void
      take_head(const std::string &line);
      /// Units of a second line, where this is one.
      bool
      take_units(const std::string &line);
      /// Whether a name is a known one but for a letter or two: then it is one that was misspelt.
      bool
      resembles_known(const std::string &name) const;
      void
      settle_columns();
      void
      take_row(const std::string &line);
      double
      value_of(const Column &column, const std::string &cell) const;

      std::string          path_;
      const MotionColumns &known_;
      const RowOptions    &options_;
      Cells                names_;
      int                  line_      = 0;
      char                 separator_ = ',';
      std::vector<Head>    heads_;
      std::vector<Column>  columns_;
      MotionFile           motion_;
    };

    Head
    Reader::renamed(const std::string &cell) const
    {
      Head own = head_of(cell);
      for (const std::string &name : {cell, trimmed(cell.substr(0, cell.find_first_of("[(")))})
        if (const auto found = options_.names.find(name); found != options_.names.end())
          {
            const bool turned = found->second[0] == '-';
            Head       here   = head_of(turned ? trimmed(found->second.substr(1)) : found->second);
            here.cell         = cell;
            here.sign         = turned ? -1 : 1;
            if (!here.has_unit && own.has_unit)
              {
                here.unit     = own.unit;
                here.has_unit = true;
              }
            return here;
          }
      return own;
    }

    void
    Reader::take_head(const std::string &line)
    {
      separator_ = separator_of(line);
      for (const std::string &cell : cells_of(line, separator_))
        heads_.push_back(renamed(cell));
    }

    bool
    Reader::take_units(const std::string &line)
    {
      const Cells cells = cells_of(line, separator_);
      const bool  bare =
        std::none_of(heads_.begin(), heads_.end(), [](const Head &head) { return head.has_unit; });
      if (!bare || cells.size() != heads_.size() ||
          std::any_of(cells.begin(), cells.end(), [](const std::string &cell) {
            return number_in(with_point(cell)) && cell != "1";
          }))
        return false;
      for (std::size_t k = 0; k < cells.size(); ++k)
        {
          heads_[k].unit     = trimmed(cells[k].find_first_of("[(") == 0 ? head_of(cells[k]).unit : cells[k]);
          heads_[k].has_unit = true;
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

    void
    Reader::settle_columns()
    {
      std::string left_out;
      for (std::size_t k = 0; k < heads_.size(); ++k)
        {
          const Head &head  = heads_[k];
          const auto  known = std::find(names_.begin(), names_.end(), head.name);
          if (known == names_.end())
            {
              if (options_.leaves && !resembles_known(head.name))
                {
                  left_out += (left_out.empty() ? "\"" : ", \"") + shown_text(head.cell, 40) + "\"";
                  continue;
                }
              fail("column \"" + shown_text(head.cell, 40) + "\" is not known" + perhaps(head.name, names_) +
                   "; there are " + join_choices(names_, "and") +
                   ", each with its unit in brackets, such as \"load [kN]\"");
            }
          const MotionColumn &column = known_[known - names_.begin()];
          if (std::any_of(
                columns_.begin(), columns_.end(), [&](const Column &other) { return other.of == &column; }))
            fail("two columns of " + head.name + "; leave one out");
          if (!head.has_unit && column.dimension != Dimension::none)
            fail("column \"" + shown_text(head.cell, 40) +
                 "\" has no unit; write it in brackets, such as \"" + head.name + " [" +
                 dimension_units(column.dimension).substr(0, dimension_units(column.dimension).find(',')) +
                 "]\"");
          try
            {
              columns_.push_back({k, &column, head.sign * unit_factor(column, head.unit)});
            }
          catch (const InputError &error)
            {
              fail("column \"" + shown_text(head.cell, 40) + "\": " + error.what());
            }
          motion_.quantities.push_back(column.quantity);
        }
      if (columns_.empty())
        fail("no column is known; there are " + join_choices(names_, "and") +
             ", each with its unit in brackets, such as \"load [kN]\"");
      if (!left_out.empty())
        motion_.notes.push_back(path_ + ": columns that are not used: " + left_out +
                                "; a table of names tells what they are called here (--columns)");
      motion_.columns.resize(columns_.size());
    }

    double
    Reader::value_of(const Column &column, const std::string &cell) const
    {
      const std::string name = column.of->name;
      if (cell.empty())
        fail("no value of " + name + "; rows cannot have gaps: fill it or leave the column out");
      const auto number = number_in(separator_ == ',' ? cell : with_point(cell));
      if (!number)
        fail("\"" + shown_text(cell, 40) + "\" of " + name +
             " is not a number; units stand in the first line");
      const double value = column.factor * *number;
      const bool   too_narrow =
        column.of->quantity == Q::radius && value != 0 && std::abs(value) < least_track_radius;
      if (too_narrow || value < column.of->least * (1 + 1e-12) - 1e-15 ||
          value > column.of->most * (1 + 1e-12))
        fail(name + " = " + shown_text(cell, 40) + " is out of range; " + column.of->range +
             " is accepted, in the unit of the first line");
      return value;
    }

    void
    Reader::take_row(const std::string &line)
    {
      const Cells cells = cells_of(line, separator_);
      if (cells.size() != heads_.size())
        fail("a row of " + std::to_string(cells.size()) + " values, the first line names " +
             std::to_string(heads_.size()) + " columns");
      for (std::size_t k = 0; k < columns_.size(); ++k)
        {
          const Column      &of    = columns_[k];
          const std::string &cell  = cells[of.cell];
          const double       value = value_of(of, cell);
          auto              &rows  = motion_.columns[k];
          if ((of.of->quantity == Q::time || of.of->quantity == Q::distance) && !rows.empty() &&
              !(value > rows.back()))
            fail(std::string(of.of->name) + " = " + shown_text(cell, 40) +
                 (value == rows.back() ? " stands in the row before, too; leave one of them out"
                                       : " is less than in the row before; sort the rows"));
          rows.push_back(value);
        }
    }

    MotionFile
    Reader::read()
    {
      const auto lines = lines_of(path_, options_.purpose);
      for (const auto &[number, line] : lines)
        {
          line_ = number;
          if (heads_.empty())
            {
              take_head(line);
              continue;
            }
          if (columns_.empty())
            {
              const bool units = take_units(line);
              line_            = lines.front().first;
              settle_columns();
              line_ = number;
              if (units)
                continue;
            }
          take_row(line);
        }
      if (!heads_.empty() && columns_.empty())
        {
          line_ = lines.front().first;
          settle_columns();
        }
      if (columns_.empty() || motion_.rows() == 0)
        throw InputError(
          path_ + ": no rows; such a table has a first line with names and units, and rows of numbers");
      return motion_;
    }
  } // namespace


  MotionFile
  read_rows(const std::string &path, const MotionColumns &known, const RowOptions &options)
  {
    return Reader(path, known, options).read();
  }


  ColumnNames
  read_column_names(const std::string &path)
  {
    ColumnNames names;
    for (const auto &[number, line] :
         lines_of(path, "--columns needs a table of names: the name in the rows, the name here"))
      {
        const Cells cells = cells_of(line, separator_of(line));
        const auto  fail  = [&, at = number](const std::string &why) {
          throw InputError(path + ":" + std::to_string(at) + ": " + why);
        };
        if (cells.size() != 2 || cells[0].empty() || cells[1].empty())
          fail(
            "a line holds two names with a comma, semicolon or tab between: that in the rows and that "
            "here, such as \"y_ws;lateral shift [mm]\"");
        Cells known;
        for (const MotionColumn &column : motion_columns())
          known.push_back(column.name);
        const std::string here = head_of(trimmed(cells[1][0] == '-' ? cells[1].substr(1) : cells[1])).name;
        if (std::find(known.begin(), known.end(), here) == known.end())
          fail("\"" + shown_text(here, 40) + "\" is no column" + perhaps(here, known) + "; there are " +
               join_choices(known, "and"));
        if (!names.emplace(cells[0], cells[1]).second)
          fail("\"" + shown_text(cells[0], 40) + "\" stands in a line before, too; leave one of them out");
      }
    return names;
  }
} // namespace wheelrail
