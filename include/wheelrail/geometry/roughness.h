#pragma once

#include <wheelrail/geometry/irregular_shapes.h>

#include <vector>

namespace wheelrail
{
  /// Roughness of a one-third-octave band of wavelengths.
  struct RoughnessBand
  {
    double wavelength = 0; ///< of its middle; nominal values (63 mm) and exact ones (63.1 mm) are taken [m]
    double level      = 0; ///< 20 lg of the root mean square height over 1 um [dB], as EN 15610 has it
  };

  /// A rough surface: waves alike all across, or over a width as those of a corrugation. Lines of the
  /// spectrum lie 1/length apart; all lines in a band have the same amplitude, so that together they have the
  /// band's level, and random phases (a seed gives the same surface everywhere). Bands reach from 10^(-1/20)
  /// to 10^(1/20) of their middle 10^(n/10) m. Over `length` around the place the waves have their whole
  /// height, on both sides of it they fade over half the longest wave, at most a quarter of the length.
  ///
  /// Throws InputError for no bands, a wavelength that is the middle of no band, a band given twice, and one
  /// without a line, since it is too long for the length.
  Irregularity
  roughness(const IrregularSize &size, const std::vector<RoughnessBand> &bands, unsigned int seed);
} // namespace wheelrail
