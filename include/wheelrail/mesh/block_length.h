#pragma once

#include <cmath>

namespace wheelrail
{
  /// How often cells are divided, from coarse to finest ones [m].
  inline unsigned int
  mesh_levels(const double cell, const double coarse)
  {
    return static_cast<unsigned int>(std::fmax(0, std::round(std::log2(coarse / cell))));
  }

  /// Coarse blocks around a wheel, a whole number. `cell`, `coarse`: the sizes asked for [m].
  inline unsigned int
  blocks_around(const double rolling_radius, const double cell, const double coarse)
  {
    const double block = cell * std::pow(2., mesh_levels(cell, coarse));
    return static_cast<unsigned int>(std::round(2 * M_PI * rolling_radius / block));
  }

  /// Place along the rail where a wheel starts that is to start `farther` along than others: whole blocks
  /// [m].
  inline double
  start_in_blocks(const double farther, const double rolling_radius, const double cell, const double coarse)
  {
    const double length = 2 * M_PI * rolling_radius / blocks_around(rolling_radius, cell, coarse);
    return std::round(farther / length) * length;
  }
} // namespace wheelrail
