#pragma once

#include <wheelrail/scene/scene.h>

namespace wheelrail
{
  /// How a rail bends on its support: an endless beam of a usual rail (5.5 MN m2) on a foundation
  /// (Winkler 1867; Timoshenko 1926) of pads and ballast, or their average.
  struct RailBending
  {
    double foundation; ///< [N/m2]
    double length;     ///< (4 EI/k)^(1/4), over which it dies away [m]
    double deflection; ///< under a force of 1 N at it [m/N]
  };

  /// For a rail that is not clamped.
  RailBending
  rail_bending(const SupportData &support);

  /// Rail length from which on a rail that is not clamped sinks and tilts under the wheel as an endless one
  /// does: two lengths of bending on either side of the rolled stretch, e^-2 of the deflection is left [m].
  double
  enough_rail(const Scene &scene);
} // namespace wheelrail
