#include <wheelrail/scene/steels.h>

#include <cmath>
#include <limits>

namespace wheelrail
{
  const std::vector<Steel> &
  rail_steels()
  {
    static const std::vector<Steel> steels{
      {"R200", 0.55 * 680e6}, {"R260", 0.55 * 880e6}, {"R260Mn", 0.55 * 880e6}, {"R350HT", 0.65 * 1175e6}};
    return steels;
  }


  const std::vector<Steel> &
  wheel_steels()
  {
    static const std::vector<Steel> steels{{"ER6", 500e6}, {"ER7", 520e6}, {"ER8", 540e6}, {"ER9", 580e6}};
    return steels;
  }


  double
  yield_strength(const MaterialData &material)
  {
    if (std::isfinite(material.yield_stress))
      return material.yield_stress;
    for (const auto &steels : {rail_steels(), wheel_steels()})
      for (const Steel &steel : steels)
        if (steel.name == material.steel)
          return steel.strength;
    return std::numeric_limits<double>::infinity();
  }
} // namespace wheelrail
