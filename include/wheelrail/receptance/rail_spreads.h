#pragma once

#include <complex>
#include <vector>

namespace wheelrail
{
  /// How a force or an observation is spread along the rail, around its place; the integral of `even` ones
  /// is 1.
  struct Spread
  {
    enum Kind
    {
      bump, ///< (1 + cos(pi s/half))/(2 half)
      even, ///< 1/(2 half)
      tilt  ///< sqrt(3) s/half/(2 half): turns, with the same mean of squares over the stretch
    };
    Kind   kind = even;
    double half = 0; ///< half of its length [m]

    double
    at(double s) const;
  };

  /// The mean of waves exp(-i k |x|) over two spreads, as a sum of weights at distances.
  struct SpreadPair
  {
    std::vector<double> distance, weight; ///< [m], [1]

    /// Spread a lies `ahead` [m] of b. `odd`: waves have the sign of the distance, too.
    SpreadPair(const Spread &a, const Spread &b, double ahead, bool odd);

    std::complex<double>
    mean(std::complex<double> k) const;
  };
} // namespace wheelrail
