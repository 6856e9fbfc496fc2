#include <wheelrail/base/errors.h>
#include <wheelrail/base/format_text.h>
#include <wheelrail/input/motion_file.h>
#include <wheelrail/tables/table.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace wheelrail
{
  namespace
  {
    /// A column that a table of rows may have.
    struct MotionColumn
    {
      MotionQuantity quantity;
      TableColumn    as;
    };
    using MotionColumns = std::vector<MotionColumn>;

    using Q = MotionQuantity;

    /// Of a vehicle simulation.
    const MotionColumns &
    motion_columns()
    {
      static const MotionColumns list = {
        {Q::time, {"time", Dimension::time, -1e9, 1e9, "", false, true}},
        {Q::distance, {"distance", Dimension::length, -1e9, 1e9, "", false, true}},
        {Q::lateral_shift, {"lateral shift", Dimension::length, -0.012, 0.012, "-12 mm to 12 mm"}},
        {Q::roll, {"roll", Dimension::angle, -0.05, 0.05, "-50 mrad to 50 mrad"}},
        {Q::yaw, {"yaw", Dimension::angle, -0.05, 0.05, "-50 mrad to 50 mrad"}},
        {Q::load, {"load", Dimension::force, 0, 5e5, "0 kN (no contact) to 500 kN"}},
        {Q::load_right, {"load right", Dimension::force, 0, 5e5, "0 kN (no contact) to 500 kN"}},
        {Q::load_left, {"load left", Dimension::force, 0, 5e5, "0 kN (no contact) to 500 kN"}},
        {Q::velocity, {"velocity", Dimension::velocity, 5 / 3.6, 500 / 3.6, "5 km/h to 500 km/h"}},
        {Q::torque, {"torque", Dimension::moment, -1e6, 1e6, "-1000 kN m to 1000 kN m"}},
        {Q::traction, {"traction", Dimension::none, -1, 1, "-1 to 1"}},
        {Q::creepage, {"creepage", Dimension::none, -0.1, 0.1, "-10 % to 10 %"}},
        {Q::lateral_creepage, {"lateral creepage", Dimension::none, -0.1, 0.1, "-10 % to 10 %"}},
        {Q::radius,
         {"radius",
          Dimension::length,
          -1e5,
          1e5,
          "20 m to 100 km on either side, or 0",
          false,
          false,
          least_track_radius}},
        {Q::curvature,
         {"curvature",
          Dimension::spin,
          -0.05,
          0.05,
          "-0.05 1/m to 0.05 1/m (a radius of 20 m on either side)"}},
        {Q::cant, {"cant", Dimension::length, -0.3, 0.3, "-300 mm to 300 mm"}}};
      return list;
    }

    /// Of kinds of traffic.
    const MotionColumns &
    mix_columns()
    {
      static const MotionColumns list = [] {
        MotionColumns columns;
        for (const MotionColumn &column : motion_columns())
          if (column.quantity != Q::torque) // which the load of a row would turn into a traction
            columns.push_back(column);
        columns.push_back({Q::weight, {"weight", Dimension::none, 0, 1e12, "0 to 1e12"}});
        return columns;
      }();
      return list;
    }

    /// Of wheels that pass one after the other.
    const MotionColumns &
    passage_columns()
    {
      static const MotionColumns list = {
        {Q::load, {"load", Dimension::force, 1e3, 5e5, "1 kN to 500 kN"}},
        {Q::lateral_shift, {"lateral shift", Dimension::length, -0.012, 0.012, "-12 mm to 12 mm"}},
        {Q::traction, {"traction", Dimension::none, -1, 1, "-1 to 1"}},
        {Q::velocity, {"velocity", Dimension::velocity, 5 / 3.6, 500 / 3.6, "5 km/h to 500 km/h"}},
        {Q::creepage, {"creepage", Dimension::none, -0.1, 0.1, "-10 % to 10 %"}}};
      return list;
    }

    /// Of the points of a creep curve.
    const MotionColumns &
    curve_columns()
    {
      static const MotionColumns list = {
        {Q::creepage, {"creepage", Dimension::none, -1, 1, "-100 % to 100 %"}},
        {Q::spin, {"spin", Dimension::spin, -100, 100, "-100 1/m to 100 1/m"}},
        {Q::longitudinal_force, {"longitudinal force", Dimension::force, -1e6, 1e6, "-1000 kN to 1000 kN"}},
        {Q::lateral_force, {"lateral force", Dimension::force, -1e6, 1e6, "-1000 kN to 1000 kN"}},
        {Q::spin_moment, {"spin moment", Dimension::moment, -1e6, 1e6, "-1000 kN m to 1000 kN m"}},
        {Q::traction, {"traction", Dimension::none, -2, 2, "-2 to 2"}}};
      return list;
    }

    /// Of a receptance over frequency.
    const MotionColumns &
    receptance_columns()
    {
      static const MotionColumns list = {
        {Q::frequency, {"frequency", Dimension::frequency, 1e-3, 1e5, "0.001 Hz to 100 kHz"}},
        {Q::receptance, {"receptance", Dimension::receptance, 0, 1, "0 to 1 m/N"}},
        {Q::mobility, {"mobility", Dimension::mobility, 0, 1, "0 to 1 m/(N s)"}},
        {Q::accelerance, {"accelerance", Dimension::accelerance, 0, 1e3, "0 to 1000 m/(s2 N)"}},
        {Q::phase, {"phase", Dimension::angle, -1e3, 1e3, "-1000 rad to 1000 rad"}}};
      return list;
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
    std::vector<TableColumn>
    columns_of(const MotionColumns &known)
    {
      std::vector<TableColumn> columns;
      for (const MotionColumn &column : known)
        columns.push_back(column.as);
      return columns;
    }

    MotionFile
    read_rows(const std::string &path, const MotionColumns &known, const TableOptions &options)
    {
      Table      table = read_table(path, columns_of(known), options);
      MotionFile rows{{}, std::move(table.columns), std::move(table.notes)};
      for (const std::size_t k : table.known)
        rows.quantities.push_back(known[k].quantity);
      if (rows.find(Q::curvature) && rows.find(Q::radius))
        throw InputError(path +
                         ": radius and curvature; one follows from the other: leave one of the columns out");
      for (std::size_t k = 0; k < rows.quantities.size(); ++k)
        if (rows.quantities[k] == Q::curvature)
          {
            rows.quantities[k] = Q::radius;
            for (double &value : rows.columns[k]) // flatter curves than a radius may have are straight
              value = std::abs(value) < 1e-5 ? 0 : 1 / value;
          }
      return rows;
    }

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
        return column.as.name;
    return "";
  }


  std::string
  motion_unit(const MotionQuantity quantity)
  {
    if (quantity == Q::torque)
      return "Nm";
    for (const MotionColumn &column : motion_columns())
      if (column.quantity == quantity)
        return column.as.dimension == Dimension::none ? "1" : si_unit(column.as.dimension);
    return "1";
  }


  namespace
  {
    MotionFile
    checked(const std::string &path, MotionFile motion)
    {
      require_one_drive(path, motion);
      require_loads(path, motion);
      if (!motion.find(Q::time) && !motion.find(Q::distance))
        throw InputError(path +
                         ": neither time nor distance; one of them must be a column, such as \"time [s]\"");
      return motion;
    }

    const char *const purpose_of_rows = "a motion is a table of rows over time or distance";
  } // namespace


  MotionFile
  read_motion_file(const std::string &path)
  {
    return checked(path, read_rows(path, motion_columns(), {purpose_of_rows, false, {}, "#", ""}));
  }


  MotionFile
  read_vehicle_file(const std::string &path, const std::string &columns)
  {
    const ColumnNames names =
      columns.empty() ? ColumnNames() : read_column_names(columns, columns_of(motion_columns()));
    return checked(path,
                   read_rows(path, motion_columns(), {purpose_of_rows, true, names, "#", "", "--columns"}));
  }


  MotionFile
  read_passage_list(const std::string &path)
  {
    MotionFile rows =
      read_rows(path,
                passage_columns(),
                {"Run/Passage list needs a table with a row for each wheel", false, {}, "#", ""});
    require_one_drive(path, rows);
    return rows;
  }


  MotionFile
  read_mix_file(const std::string &path)
  {
    MotionFile rows =
      read_rows(path,
                mix_columns(),
                {"Wear/Mix needs a table with a row for each kind of traffic", false, {}, "#", ""});
    require_one_drive(path, rows);
    require_loads(path, rows);
    // what has no column is that of the scene
    const auto above_zero = [&](const Q quantity, const std::size_t row) {
      const auto *const column = rows.find(quantity);
      return !column || (*column)[row] > 0;
    };
    for (std::size_t row = 0; row < rows.rows(); ++row)
      if (above_zero(Q::weight, row) && above_zero(Q::load, row) &&
          (above_zero(Q::load_right, row) || above_zero(Q::load_left, row)))
        return rows;
    throw InputError(path +
                     ": no row has both a weight and a load above 0; write how often each row passes, "
                     "and with which load");
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
      read_rows(path,
                curve_columns(),
                {"--beside needs a table of points to draw beside the curve", false, {}, "#", ""});
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
  read_receptance_file(const std::string &path)
  {
    MotionFile rows =
      read_rows(path,
                receptance_columns(),
                {"--beside needs a table over frequencies to draw beside the result", true, {}, "#", ""});
    if (!rows.find(Q::frequency))
      throw InputError(path + ": no frequency; name a column \"frequency [Hz]\"");
    for (const MotionQuantity shown : {Q::receptance, Q::mobility, Q::accelerance})
      if (rows.find(shown))
        return rows;
    throw InputError(path + ": nothing to draw; name a column receptance, mobility or accelerance");
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
