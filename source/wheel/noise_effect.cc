#include <wheelrail/base/errors.h>
#include <wheelrail/wheel/coarse_halfspaces.h>
#include <wheelrail/wheel/noise_effect.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace wheelrail
{
  double
  noise_effect(const Scene &scene, const SceneGeometry &geometry, const double normal_force)
  {
    constexpr unsigned int few = 2, draws = 16;
    constexpr double       none = 2e-3; // what the first draws of exact points stay below
    if (!geometry.files.rail && !geometry.files.wheel)
      return Measures::none;
    const Scene          coarse  = coarse_halfspaces(scene);
    const SectionOffsets offsets = scene_offsets(scene);
    const auto           peak    = [&](const SceneGeometry &with) {
      return halfspace_pressure(coarse, with, normal_force, offsets).peak;
    };
    double       squares = 0, largest = 0;
    unsigned int n = 0;
    try
      {
        for (const double as_smoothed = peak(geometry); n < draws && (n < few || largest > none); ++n)
          {
            const double change = peak(drawn(coarse, geometry, n + 1)) / as_smoothed - 1;
            squares += change * change;
            largest = std::max(largest, std::abs(change));
          }
      }
    catch (const InputError &)
      {
        return std::numeric_limits<double>::infinity();
      }
    return 2 * std::sqrt(squares / n);
  }


  void
  find_noise_effect(const Scene &scene, const SceneGeometry &geometry, WheelRailSolution &result)
  {
    const double force  = sum_over_patches(result, [](const auto &patch) { return patch.solution.fn; });
    result.noise_effect = noise_effect(scene, geometry, force);
  }
} // namespace wheelrail
