#include <wheelrail/mesh/wheel_section_outline.h>
#include <wheelrail/wheel/wheel_load.h>

#include <cmath>

namespace wheelrail
{
  double
  static_wheel_load(const Scene &scene, const WheelProfile &profile)
  {
    if (scene.wheel_load > 0)
      return scene.wheel_load;
    const WheelDimensions dimensions = scene.wheel_dimensions();
    const double moment = moment_about_axle(make_wheel_section_outline(profile, dimensions), dimensions);
    return (scene.sprung_mass + scene.axle_mass + 2 * M_PI * moment * scene.wheel_material.density) *
           scene.gravity;
  }
} // namespace wheelrail
