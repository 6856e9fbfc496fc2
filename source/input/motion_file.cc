#include <wheelrail/base/choices.h>
#include <wheelrail/base/errors.h>
#include <wheelrail/base/file_kind.h>
#include <wheelrail/base/quantity.h>
#include <wheelrail/base/read_file.h>
#include <wheelrail/base/shown_text.h>
#include <wheelrail/base/split_list.h>
#include <wheelrail/input/motion_columns.h>
#include <wheelrail/input/motion_file.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <sstream>

namespace wheelrail
{
  namespace
  {
    using Q = MotionQuantity;

    std::string
    trimmed(const std::string &text)
    {
      const std::size_t first = text.find_first_not_of(" \t\r\""), last = text.find_last_not_of(" \t\r\"");
      return first == std::string::npos ? "" : text.substr(first, last - first + 1);
    }

    std::vector<std::string>
    cells_of(const std::string &line, const char separator)
    {
      std::vector<std::string> cells = split_list(line, separator);
      for (std::string &cell : cells)
        cell = trimmed(cell);
      return cells;
    }

    /// Reads one file.
    class Reader
    {
    public:
      Reader(const std::string &path, const MotionColumns &known, const std::string &purpose)
        : path_(path)
        , known_(known)
        , purpose_(purpose)
      {
      }

      MotionFile
      read();

    private:
      [[noreturn]] void
      fail(const std::string &why) const
      {
        throw InputError(path_ + ":" + std::to_string(line_) + ": " + why);
      }
      void
      read_header(const std::string &line);
      void
      read_row(const std::string &line);

      std::string                       path_;
      const MotionColumns              &known_;
      std::string                       purpose_; ///< what needs the file, for messages
      int                               line_      = 0;
      char                              separator_ = ',';
      std::vector<const MotionColumn *> columns_;
      std::vector<double>               factors_;
      MotionFile                        motion_;
    };

    void
    Reader::read_header(const std::string &line)
    {
      separator_ = line.find(';') != std::string::npos   ? ';'
                   : line.find(',') != std::string::npos ? ','
                                                         : '\t';
      for (const std::string &cell : cells_of(line, separator_))
        {
          const std::size_t open = cell.find_first_of("[("), close = cell.find_last_of("])");
          std::string       name = trimmed(cell.substr(0, open));
          std::transform(
            name.begin(), name.end(), name.begin(), [](const char c) { return c == '_' ? ' ' : c; });
          std::vector<std::string> names;
          for (const MotionColumn &column : known_)
            names.push_back(column.name);
          const auto known = std::find(names.begin(), names.end(), name);
          if (known == names.end())
            fail("column \"" + shown_text(cell, 40) + "\" is not known" + perhaps(name, names) +
                 "; there are " + join_choices(names, "and") +
                 ", each with its unit in brackets, such as \"load [kN]\"");
          const MotionColumn &column = known_[known - names.begin()];
          if (std::find(columns_.begin(), columns_.end(), &column) != columns_.end())
            fail("two columns of " + name + "; leave one out");
          const bool has_unit = open != std::string::npos && close != std::string::npos && close > open;
          if (!has_unit && column.dimension != Dimension::none)
            fail("column \"" + shown_text(cell, 40) + "\" has no unit; write it in brackets, such as \"" +
                 name + " [" +
                 dimension_units(column.dimension).substr(0, dimension_units(column.dimension).find(',')) +
                 "]\"");
          try
            {
              factors_.push_back(
                unit_factor(column, has_unit ? trimmed(cell.substr(open + 1, close - open - 1)) : ""));
            }
          catch (const InputError &error)
            {
              fail("column \"" + shown_text(cell, 40) + "\": " + error.what());
            }
          columns_.push_back(&column);
          motion_.quantities.push_back(column.quantity);
        }
      motion_.columns.resize(columns_.size());
    }

    void
    Reader::read_row(const std::string &line)
    {
      const auto cells = cells_of(line, separator_);
      if (cells.size() != columns_.size())
        fail("a row of " + std::to_string(cells.size()) + " values, the first line names " +
             std::to_string(columns_.size()) + " columns");
      for (std::size_t k = 0; k < cells.size(); ++k)
        {
          const std::string name = columns_[k]->name;
          if (cells[k].empty())
            fail("no value of " + name + "; rows cannot have gaps: fill it or leave the column out");
          double value = 0;
          try
            {
              value = factors_[k] * parse_quantity(cells[k], Dimension::none);
            }
          catch (const InputError &)
            {
              fail("\"" + shown_text(cells[k], 40) + "\" of " + name +
                   " is not a number; units stand in the first line");
            }
          const bool too_narrow =
            columns_[k]->quantity == Q::radius && value != 0 && std::abs(value) < least_track_radius;
          if (too_narrow || value < columns_[k]->least * (1 + 1e-12) - 1e-15 ||
              value > columns_[k]->most * (1 + 1e-12))
            fail(name + " = " + shown_text(cells[k], 40) + " is out of range; " + columns_[k]->range +
                 " is accepted, in the unit of the first line");
          auto &column = motion_.columns[k];
          if ((columns_[k]->quantity == Q::time || columns_[k]->quantity == Q::distance) && !column.empty() &&
              !(value > column.back()))
            fail(name + " = " + shown_text(cells[k], 40) +
                 (value == column.back() ? " stands in the row before, too; leave one of them out"
                                         : " is less than in the row before; sort the rows"));
          column.push_back(value);
        }
    }

    MotionFile
    Reader::read()
    {
      if (const std::string other = other_than_a_file(path_); !other.empty())
        throw InputError(path_ + ": " + other + "; " + purpose_);
      if (!std::filesystem::exists(path_))
        throw InputError(path_ + ": no such file; " + purpose_);
      std::istringstream text(read_whole_file(path_));
      for (std::string line; std::getline(text, line);)
        {
          ++line_;
          line = line.substr(0, line.find('#'));
          if (line_ == 1 && line.compare(0, 3, "\xEF\xBB\xBF") == 0)
            line = line.substr(3);
          if (trimmed(line).empty())
            continue;
          if (columns_.empty())
            read_header(line);
          else
            read_row(line);
        }
      if (columns_.empty() || motion_.rows() == 0)
        throw InputError(
          path_ + ": no rows; such a table has a first line with names and units, and rows of numbers");
      return motion_;
    }
  } // namespace


  const std::vector<double> *
  MotionFile::find(const MotionQuantity quantity) const
  {
    const auto at = std::find(quantities.begin(), quantities.end(), quantity);
    return at == quantities.end() ? nullptr : &columns[at - quantities.begin()];
  }


  namespace
  {
    /// Throws InputError for two columns that drive.
    void
    require_one_drive(const std::string &path, const MotionFile &rows)
    {
      std::vector<std::string> drives;
      for (const MotionQuantity drive : {Q::torque, Q::traction, Q::creepage})
        if (rows.find(drive))
          drives.push_back(motion_name(drive));
      if (drives.size() > 1)
        throw InputError(path + ": " + drives[0] + " and " + drives[1] +
                         "; one follows from the other: leave one of the columns out");
    }

    /// Throws InputError for a load of both wheels beside one of each, or for that of one alone.
    void
    require_loads(const std::string &path, const MotionFile &rows)
    {
      const bool right = rows.find(Q::load_right), left = rows.find(Q::load_left);
      if (right != left)
        throw InputError(path + ": " + (right ? "load right" : "load left") + " without " +
                         (right ? "load left" : "load right") +
                         "; write both, or load for a load that both wheels have");
      if (right && rows.find(Q::load))
        throw InputError(path + ": load beside load right and load left; leave it out, or the two others");
    }
  } // namespace


  bool
  has_drive(const MotionFile &motion)
  {
    return motion.find(Q::torque) || motion.find(Q::traction) || motion.find(Q::creepage);
  }


  std::string
  motion_name(const MotionQuantity quantity)
  {
    for (const MotionColumn &column : motion_columns())
      if (column.quantity == quantity)
        return column.name;
    return "";
  }


  std::string
  motion_unit(const MotionQuantity quantity)
  {
    if (quantity == Q::torque)
      return "Nm";
    for (const MotionColumn &column : motion_columns())
      if (column.quantity == quantity)
        return column.dimension == Dimension::none ? "1" : si_unit(column.dimension);
    return "1";
  }


  MotionFile
  read_motion_file(const std::string &path)
  {
    const MotionFile motion =
      Reader(path, motion_columns(), "a motion is a table of rows over time or distance").read();
    require_one_drive(path, motion);
    require_loads(path, motion);
    if (!motion.find(Q::time) && !motion.find(Q::distance))
      throw InputError(path +
                       ": neither time nor distance; one of them must be a column, such as \"time [s]\"");
    return motion;
  }


  MotionFile
  read_passage_list(const std::string &path)
  {
    MotionFile rows =
      Reader(path, passage_columns(), "Run/Passage list needs a table with a row for each wheel").read();
    require_one_drive(path, rows);
    return rows;
  }


  MotionFile
  read_mix_file(const std::string &path)
  {
    MotionFile rows =
      Reader(path, mix_columns(), "Wear/Mix needs a table with a row for each kind of traffic").read();
    require_one_drive(path, rows);
    require_loads(path, rows);
    if (const auto *const weights = rows.find(Q::weight);
        weights && std::all_of(weights->begin(), weights->end(), [](const double w) { return w == 0; }))
      throw InputError(path + ": all weights are 0; write how often each row passes");
    return rows;
  }


  bool
  is_list_of_scenes(const std::string &passage_list)
  {
    const std::string              end   = ".prm";
    const std::vector<std::string> names = split_list(passage_list, ',');
    return std::any_of(names.begin(), names.end(), [&](const std::string &name) {
      return name.size() > end.size() && name.compare(name.size() - end.size(), end.size(), end) == 0;
    });
  }


  MotionFile
  read_curve_file(const std::string &path, const MotionQuantity over)
  {
    MotionFile rows =
      Reader(path, curve_columns(), "--beside needs a table of points to draw beside the curve").read();
    const std::string name = over == Q::spin ? "spin" : "creepage";
    if (!rows.find(over))
      throw InputError(path + ": no " + name + "; the curve runs over it: name a column \"" + name +
                       (over == Q::spin ? " [1/m]\"" : " [%]\""));
    for (const MotionQuantity shown : {Q::longitudinal_force, Q::lateral_force, Q::spin_moment, Q::traction})
      if (rows.find(shown))
        return rows;
    throw InputError(path +
                     ": nothing to draw; name a column longitudinal force, lateral force, spin moment or "
                     "traction");
  }


  MotionFile
  of_wheel(const MotionFile &motion, const bool left)
  {
    MotionFile wheel;
    const bool loads_given = motion.find(Q::load_right); // the cant is in them already
    for (std::size_t k = 0; k < motion.quantities.size(); ++k)
      if (const Q quantity = motion.quantities[k];
          quantity != (left ? Q::load_right : Q::load_left) && !(loads_given && quantity == Q::cant))
        {
          wheel.quantities.push_back(quantity == Q::load_right || quantity == Q::load_left ? Q::load
                                                                                           : quantity);
          wheel.columns.push_back(motion.columns[k]);
        }
    return wheel;
  }


  Scene
  scene_at(const Scene &scene, const MotionFile &motion, const std::size_t row)
  {
    Scene      at  = scene;
    const auto set = [&](const MotionQuantity quantity, double &entry) {
      if (const auto *const column = motion.find(quantity))
        {
          entry = (*column)[row];
          return true;
        }
      return false;
    };
    set(Q::lateral_shift, at.lateral_shift);
    if (set(Q::roll, at.roll_angle))
      at.roll = RollMode::given;
    set(Q::yaw, at.yaw);
    set(Q::load, at.wheel_load);
    set(Q::velocity, at.velocity);
    if (set(Q::traction, at.traction_coefficient))
      at.drive = Drive::torque;
    if (set(Q::creepage, at.creepage))
      at.drive = Drive::rate;
    set(Q::lateral_creepage, at.lateral_creepage);
    if (set(Q::radius, at.track_radius) && at.track_radius == 0)
      at.track_radius = std::numeric_limits<double>::infinity();
    set(Q::cant, at.cant);
    return at;
  }
} // namespace wheelrail
