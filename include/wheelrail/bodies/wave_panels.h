#pragma once

#include <vector>

namespace wheelrail
{
  /// A wave of an inverse Fourier transform and its weight, both [1/m], or of waves around a wheel [1].
  struct Wave
  {
    double k = 0, weight = 0;
  };

  /// Gauss points of (1/pi) times an integral over k from `low` to `high`: panels that grow by half from
  /// `first` on and turn by at most three radians over the longest lag.
  std::vector<Wave>
  wave_panels(double low, double high, double first, double longest);
} // namespace wheelrail
