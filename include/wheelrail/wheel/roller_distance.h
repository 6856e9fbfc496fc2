#pragma once

#include <wheelrail/scene/scene.h>

#include <functional>
#include <string>
#include <vector>

namespace wheelrail
{
  /// Two rollers of a test rig on parallel axes, or a roller on a bar, before they deform.
  struct RollerDistance
  {
    double                        radius_along = 0;          ///< relative radius in the rolling direction [m]
    double                        low = 0, high = 0;         ///< lateral ends of the narrower one [m]
    std::function<double(double)> across;                    ///< distance at a lateral place [m]
    std::function<double(double)> middle;                    ///< height midway between both surfaces [m]
    std::vector<std::string>      notes;                     ///< what was done to crowns of files
    double                        lowest = 0, lowest_at = 0; ///< of `across`, and where [m]
    double                        radius_across = 0;         ///< there, about [m]
  };

  /// The rollers of a scene (Half-space/Wheel roller radius and so on): circles along, arcs of circles or the
  /// crowns of profile files across, centred on each other. Throws InputError for two straight bodies, for a
  /// crown smaller than half the width, and for files that cannot be read or end within the width.
  RollerDistance
  roller_distance(const Scene &scene);
} // namespace wheelrail
