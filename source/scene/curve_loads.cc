#include <wheelrail/scene/curve_loads.h>

#include <algorithm>
#include <cmath>

namespace wheelrail
{
  CurveLoads
  curve_loads(const Scene &scene, const double right, const double left, const double half_base)
  {
    if (!std::isfinite(scene.cant))
      return {right, left, std::nan(""), 0};
    const double axle = right + left, g = scene.gravity;
    CurveLoads   loads;
    loads.acceleration =
      scene.velocity * scene.velocity / scene.track_radius - g * scene.cant / (2 * half_base);
    const double transfer = std::clamp(scene.centre_height / half_base * loads.acceleration / g, -1., 1.);
    loads.right           = 0.5 * axle * (1 + transfer);
    loads.left            = 0.5 * axle * (1 - transfer);
    loads.lateral         = axle / g * loads.acceleration;
    return loads;
  }
} // namespace wheelrail
