#include <wheelrail/base/errors.h>
#include <wheelrail/base/format_text.h>
#include <wheelrail/commands/scene_row.h>
#include <wheelrail/input/entries.h>
#include <wheelrail/model/scene_geometry.h>
#include <wheelrail/model/scene_motion.h>
#include <wheelrail/wheel/wheel_load.h>

#include <charconv>
#include <cstddef>
#include <filesystem>

namespace wheelrail
{
  namespace
  {
    /// Takes a torque [N m] as the traction coefficient that it has.
    void
    drive_with(const double torque, Scene &scene)
    {
      const SceneGeometry geometry = make_geometry(scene);
      scene.drive                  = Drive::torque;
      scene.traction_coefficient =
        torque / (geometry.contact.rolling_radius * static_wheel_load(scene, geometry.wheel));
    }
  } // namespace


  RowDrive
  row_drive(const std::string &option)
  {
    if (option != "from scene")
      throw InputError("--traction " + shown_text(option) +
                       ": write --traction from scene, or leave it out for rows that roll freely");
    return RowDrive::from_scene;
  }


  Scene
  scene_for_rows(const Scene &scene, const MotionFile &rows, const RowDrive drive)
  {
    if (drive == RowDrive::from_scene && has_drive(rows))
      throw InputError(
        "--traction from scene: the rows have a torque, traction or creepage of their own; "
        "leave the option or the column out");
    Scene base = scene;
    if (drive == RowDrive::none)
      {
        base.drive                = Drive::torque;
        base.traction_coefficient = 0;
        base.creepage             = 0;
      }
    return base;
  }


  std::string
  drive_of_rows(const Scene &scene, const MotionFile &rows, const RowDrive drive)
  {
    if (has_drive(rows))
      return "";
    const std::string none = "no torque, traction or creepage in the rows: the wheels ";
    if (drive == RowDrive::none)
      return none + "roll freely, whatever the scene says; --traction from scene drives them as it says";
    return none + "are driven as the scene says, " +
           entry_text(scene, "Wheelset", scene.drive == Drive::rate ? "Creepage" : "Traction coefficient");
  }


  std::string
  file_of_row(const std::string &place)
  {
    return place.substr(0, place.rfind(':'));
  }


  Scene
  scene_of_row(const Scene &scene, const std::string &place, const RowDrive drive)
  {
    const auto refuse = [&](const std::string &why) -> void {
      throw InputError("--row \"" + shown_text(place) + "\": " + why);
    };
    const std::size_t colon  = place.rfind(':');
    std::size_t       number = 0;
    if (colon == std::string::npos || colon == 0 ||
        std::from_chars(place.data() + colon + 1, place.data() + place.size(), number).ptr !=
          place.data() + place.size() ||
        colon + 1 == place.size())
      refuse("write a file of rows and the number of one, such as prm/s_curve.csv:25");
    const MotionFile motion = of_wheel(read_vehicle_file(file_of_row(place)), scene.left_wheel);
    if (number < 1 || number > motion.rows())
      refuse("the file has the rows 1 to " + std::to_string(motion.rows()));
    Scene at = scene_at(scene_for_rows(scene, motion, drive), motion, number - 1);
    if (const auto *const loads = motion.find(MotionQuantity::load); loads && (*loads)[number - 1] == 0)
      refuse("without a load there is no contact; take another row");
    if (const auto *const torques = motion.find(MotionQuantity::torque))
      drive_with((*torques)[number - 1], at);
    // that of the scene may tell another speed, load or curve
    at.title = "Row " + std::to_string(number) + " of " +
               std::filesystem::path(file_of_row(place)).filename().string();
    return at;
  }


  Scene
  scene_at_start(const Scene &scene)
  {
    if (scene.motion == "none")
      return scene;
    const SceneMotion motion(scene);
    Scene             at = motion.at(0);
    if (motion.has(MotionQuantity::torque))
      drive_with(motion.value(MotionQuantity::torque, 0), at);
    return at;
  }
} // namespace wheelrail
