#include <wheelrail/base/errors.h>
#include <wheelrail/wheel/coarse_halfspaces.h>
#include <wheelrail/wheel/noise_effect.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace wheelrail
{
  NoiseEffect
  noise_effect(const Scene &scene, const SceneGeometry &geometry, const double normal_force)
  {
    constexpr unsigned int few   = 2;
    const unsigned int     draws = draws_irregularities(geometry) ? 6 : 16; // irregular ones take longer
    constexpr double       none  = 2e-3; // what the first draws of exact points stay below
    if (!geometry.files.rail && !geometry.files.wheel && !draws_irregularities(geometry))
      return {};
    const Scene          coarse  = coarse_halfspaces(scene);
    const SectionOffsets offsets = scene_offsets(scene);
    const auto           results = [&](const SceneGeometry &with) {
      const HalfspacePressure found = halfspace_pressure(coarse, with, normal_force, offsets);
      return std::array<double, 5>{
        found.peak, found.width * found.length, found.width, found.length, found.approach};
    };
    std::array<double, 5> squares{};
    double                largest = 0;
    unsigned int          n       = 0;
    try
      {
        const std::array<double, 5> as_smoothed = results(geometry);
        for (; n < draws && (n < few || largest > none); ++n)
          {
            const std::array<double, 5> other = results(drawn(coarse, geometry, n + 1));
            for (std::size_t k = 0; k < squares.size(); ++k)
              squares[k] += std::pow(other[k] / as_smoothed[k] - 1, 2);
            largest = std::max(largest, std::abs(other[0] / as_smoothed[0] - 1));
          }
      }
    catch (const InputError &)
      {
        squares.fill(std::numeric_limits<double>::infinity());
      }
    const auto share = [&](const std::size_t k) { return 2 * std::sqrt(squares[k] / std::max(n, 1u)); };
    return {share(0), share(1), share(2), share(3), share(4)};
  }


  void
  find_noise_effect(const Scene &scene, const SceneGeometry &geometry, WheelRailSolution &result)
  {
    const double force  = sum_over_patches(result, [](const auto &patch) { return patch.solution.fn; });
    result.noise_effect = noise_effect(scene, geometry, force);
  }
} // namespace wheelrail
