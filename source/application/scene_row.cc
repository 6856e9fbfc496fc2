#include <wheelrail/application/scene_row.h>
#include <wheelrail/base/errors.h>
#include <wheelrail/base/shown_text.h>
#include <wheelrail/model/scene_geometry.h>
#include <wheelrail/reference/motion_file.h>
#include <wheelrail/reference/wheel_load.h>

#include <charconv>
#include <cstddef>

namespace wheelrail
{
  Scene
  scene_of_row(const Scene &scene, const std::string &place)
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
    const MotionFile motion = read_motion_file(place.substr(0, colon));
    if (number < 1 || number > motion.rows())
      refuse("the file has the rows 1 to " + std::to_string(motion.rows()));
    Scene at = scene_at(scene, motion, number - 1);
    if (const auto *const loads = motion.find(MotionQuantity::load); loads && (*loads)[number - 1] == 0)
      refuse("without a load there is no contact; take another row");
    if (const auto *const torques = motion.find(MotionQuantity::torque))
      {
        const SceneGeometry geometry = make_geometry(at);
        at.drive                     = Drive::torque;
        at.traction_coefficient =
          (*torques)[number - 1] / (geometry.contact.rolling_radius * static_wheel_load(at, geometry));
      }
    return at;
  }
} // namespace wheelrail
