#pragma once

// Hertz's contact for the program's operator and elements: two equal elastic bodies, one of them modelled,
// against the rigid surface of symmetry.

#include "contact.h"

#include <string>

namespace scenes
{
  enum class HertzShape
  {
    point,   ///< a = b = 6.69 mm
    ellipse, ///< 7.16 mm along, 5.39 mm across
    line     ///< plane strain, half-width 5 mm
  };

  struct HertzRun
  {
    // relative errors against the exact solution
    double peak = 0, approach = 0, area = 0, mises = 0,
           depth         = 0;                    ///< [1]; depth of the largest von Mises stress
    double force         = 0;                    ///< vertical balance: |contact - load|/load
    double peak_pressure = 0;                    ///< exact [Pa]
    double surface       = 0;                    ///< lateral stress at the top over the exact peak pressure
    double elements = 0, steps = 0, seconds = 0; ///< seconds: CPU time of the steps
    double penetration = 0;                      ///< of the layer at the peak [m]
  };

  /// Relaxes the contact with cells of size `cell` [m] and the penalty scale f between the two bodies. A
  /// quarter of the block is modelled (a strip for the line); its outer faces move as the half-space under
  /// the exact pressure would, so the approach is that of the half-space. The line has none (error 0).
  /// `load`: of bodies with a tenth of the scene's radii, 460 mm and 300 mm (0.1 to 300 kN) [N]; the patch
  /// is the same, the pressure a tenth. The line has a fixed load.
  HertzRun
  run_hertz(HertzShape shape, double cell, double scale, bool filter = true, double load = 1e5);

  /// One line of a table with these figures in per cent; an empty `run` gives the heading.
  std::string
  hertz_row(HertzShape shape, double cell, double scale, const HertzRun *run);
} // namespace scenes
