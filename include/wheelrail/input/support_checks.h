#pragma once

#include <wheelrail/input/cross_checks.h>

namespace wheelrail
{
  /// Track/Support and its entries against each other and against the rail.
  void
  check_support(const Scene &scene, Findings &found);

  /// How a rail bends on what it stands on: an endless beam of a usual rail (5.5 MN m2) on a foundation
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
} // namespace wheelrail
