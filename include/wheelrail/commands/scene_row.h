#pragma once

#include <wheelrail/input/motion_file.h>
#include <wheelrail/scene/scene.h>

#include <string>

namespace wheelrail
{
  /// What drives the wheel at rows of a vehicle simulation that have no column for it.
  enum class RowDrive
  {
    none,      ///< nothing: it rolls freely, whatever the scene says
    from_scene ///< what drives the scene
  };

  /// What `--traction` asks for. Throws InputError for anything but "from scene".
  RowDrive
  row_drive(const std::string &option);

  /// The scene at the rows of a file before their columns take the place of its entries: rolling freely,
  /// unless the rows or the scene drive. Throws InputError when both should.
  Scene
  scene_for_rows(const Scene &scene, const MotionFile &rows, RowDrive drive);

  /// What drives rows without a column for it, for the screen; empty where they have one.
  std::string
  drive_of_rows(const Scene &scene, const MotionFile &rows, RowDrive drive);

  /// The file of a place such as "prm/s_curve.csv:25", without the number of the row.
  std::string
  file_of_row(const std::string &place);

  /// The scene at one row of a vehicle simulation: `place` is the file and the number of the row, from 1, as
  /// "prm/s_curve.csv:25". A torque becomes the traction coefficient that it has at the rolling radius and
  /// the wheel load; without a column that drives see scene_for_rows(). Throws InputError that names --row,
  /// file and number.
  Scene
  scene_of_row(const Scene &scene, const std::string &place, RowDrive drive = RowDrive::none);

  /// The scene at the place where it starts to follow its Wheelset/Motion, or the scene itself when it
  /// follows none; a torque likewise. Throws InputError as SceneMotion does.
  Scene
  scene_at_start(const Scene &scene);
} // namespace wheelrail
