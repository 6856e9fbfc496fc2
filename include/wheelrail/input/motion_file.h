#pragma once

#include <wheelrail/scene/scene.h>

#include <string>
#include <vector>

namespace wheelrail
{
  /// What a column of a motion file holds.
  enum class MotionQuantity
  {
    time,
    distance,
    lateral_shift,
    roll,
    yaw,
    load,
    load_right,
    load_left,
    velocity,
    torque,
    traction,
    creepage,
    lateral_creepage,
    radius,    ///< of the track; 0: straight
    curvature, ///< its inverse, in files alone
    cant,
    spin,
    longitudinal_force,
    lateral_force,
    spin_moment,
    weight, ///< of a row in a mix
    frequency,
    receptance,
    mobility,
    accelerance,
    phase
  };

  /// Rows of numbers under names: of a vehicle simulation over time or distance, or one a passage.
  struct MotionFile
  {
    std::vector<MotionQuantity>      quantities;
    std::vector<std::vector<double>> columns; ///< [SI], one value a row
    std::vector<std::string>         notes;   ///< what of the file was left out, sentences

    std::size_t
    rows() const
    {
      return columns.front().size();
    }
    /// The column of a quantity, or null.
    const std::vector<double> *
    find(MotionQuantity quantity) const;
  };

  /// Whether a column says what drives the wheels of the rows: torque, traction or creepage.
  bool
  has_drive(const MotionFile &motion);

  /// The name of a column, as in the file.
  std::string
  motion_name(MotionQuantity quantity);

  /// The SI unit of a column: "m", "rad", "m/s"; "1" of pure numbers.
  std::string
  motion_unit(MotionQuantity quantity);

  /// Reads a table with commas, semicolons or tabs between and a first line that names each column and its
  /// unit: "time [s], lateral shift [mm], yaw [mrad], load [kN]". What follows # is a remark. There must be
  /// time or distance, which grows from row to row; loads of both wheels, or one that both have. Throws
  /// InputError, with file, line and column, for everything else.
  MotionFile
  read_motion_file(const std::string &path);

  /// Reads the results of a vehicle simulation in the same form. Columns that are not known are left out with
  /// a note. `columns`: a file that says what columns are called here (read_column_names()); empty: none.
  /// Throws InputError as read_motion_file().
  MotionFile
  read_vehicle_file(const std::string &path, const std::string &columns = "");

  /// Reads a table of the same form whose rows are wheels that pass one after the other: "load [kN],
  /// lateral shift [mm], traction, velocity [km/h], creepage [%]", any of them. Throws InputError as
  /// read_motion_file().
  MotionFile
  read_passage_list(const std::string &path);

  /// Whether a Run/Passage list names scenes, "a.prm, b.prm", and not a table.
  bool
  is_list_of_scenes(const std::string &passage_list);

  /// Reads a table of the same form whose rows are kinds of traffic, with the columns of read_motion_file()
  /// and "weight", any of them but a torque. Throws InputError as read_motion_file(), and for weights of 0
  /// in all rows.
  MotionFile
  read_mix_file(const std::string &path);

  /// Reads a table of the same form whose rows are points of a creep curve, measured or of another program:
  /// "creepage [%]" or "spin [1/m]", and "longitudinal force [kN], lateral force [kN], spin moment [N m],
  /// traction", any of them. `over`: creepage or spin, which must be there. Throws InputError as
  /// read_motion_file().
  MotionFile
  read_curve_file(const std::string &path, MotionQuantity over);

  /// Reads a table of the same form whose rows are frequencies of a measured or computed track or wheel:
  /// "frequency [Hz], mobility [m/(N s)]", receptance or accelerance in the place of the mobility, or several
  /// of them, and "phase [deg]", that of the first of them. Throws InputError as read_motion_file().
  MotionFile
  read_receptance_file(const std::string &path);

  /// The rows as one wheel of the wheelset has them: its own load (load right, load left) as the load, and
  /// beside such loads no cant, which would move load once more.
  MotionFile
  of_wheel(const MotionFile &motion, bool left);

  /// The scene at a row of one wheel: columns in the place of its entries. A torque is not an entry: see
  /// vehicle.h.
  Scene
  scene_at(const Scene &scene, const MotionFile &motion, std::size_t row);
} // namespace wheelrail
