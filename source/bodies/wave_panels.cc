#include <wheelrail/bodies/wave_panels.h>

#include <algorithm>
#include <array>
#include <cmath>

// Wavenumbers and weights of (3) in doc/theory/bodies.md: the integral over k as a sum.

namespace wheelrail
{
  namespace
  {
    // Gauss points of four on [0, 1]
    constexpr std::array<double, 4> gauss_place{
      {0.0694318442029737, 0.3300094782075719, 0.6699905217924281, 0.9305681557970263}};
    constexpr std::array<double, 4> gauss_weight{
      {0.1739274225687269, 0.3260725774312731, 0.3260725774312731, 0.1739274225687269}};
  } // namespace


  std::vector<Wave>
  wave_panels(const double low, const double high, const double first, const double longest)
  {
    std::vector<Wave> waves;
    // (3) of doc/theory/bodies.md: cos(k z) turns by (width of the panel) z, at most three radians at the
    // longest lag, which four Gauss points integrate; panels grow by half towards long k, where D is smooth
    // in log k
    const double widest = 3 / longest;
    for (double k = low, width = first; k < high; width = std::min(1.5 * width, widest))
      {
        // the last panel takes what would be less than a fifth of one; the weight has the 1/pi of (3)
        const double end = k + 1.2 * width > high ? high : k + width;
        for (int g = 0; g < 4; ++g)
          waves.push_back({k + gauss_place[g] * (end - k), gauss_weight[g] * (end - k) / M_PI});
        k = end;
      }
    return waves;
  }
} // namespace wheelrail
