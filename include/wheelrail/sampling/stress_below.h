#pragma once

#include <wheelrail/output/slice_file.h>
#include <wheelrail/output/summary.h>

#include <vector>

namespace wheelrail
{
  /// Largest von Mises stress of the cuts through a loaded contact.
  struct StressBelow
  {
    double surface = 0; ///< at the surface [Pa]
    double below   = 0; ///< `from` deep and deeper [Pa]
    double depth   = 0; ///< where that is, by the parabola through three depths [m]
  };

  /// Of rail and wheel in AA, BB, AA_peak and BB_peak. Of finite elements the stress at the surface and in
  /// the cell below it is that of a coarse slope, so that what lies deeper is distinguished.
  StressBelow
  largest_stress_below(const std::vector<Slice> &slices, double from);

  /// Sets its figures.
  void
  set_stress_below(const StressBelow &stress, Summary &summary);
} // namespace wheelrail
