#include <deal.II/base/quadrature_lib.h>

#include <wheelrail/bodies/wave_panels.h>

#include <algorithm>
#include <cmath>

// Wavenumbers and weights of (3) in doc/theory/bodies.md: the integral over k as a sum.

namespace wheelrail
{
  std::vector<Wave>
  wave_panels(const double low, const double high, const double first, const double longest)
  {
    static const dealii::QGauss<1> gauss(4);
    std::vector<Wave>              waves;
    // (3) of doc/theory/bodies.md: cos(k z) turns by (width of the panel) z, at most three radians at the
    // longest lag, which four Gauss points integrate; panels grow by half towards long k, where D is smooth
    // in log k
    const double widest = 3 / longest;
    for (double k = low, width = first; k < high; width = std::min(1.5 * width, widest))
      {
        // the last panel takes what would be less than a fifth of one; the weight has the 1/pi of (3)
        const double end = k + 1.2 * width > high ? high : k + width;
        for (unsigned int g = 0; g < gauss.size(); ++g)
          waves.push_back({k + gauss.point(g)[0] * (end - k), gauss.weight(g) * (end - k) / M_PI});
        k = end;
      }
    return waves;
  }
} // namespace wheelrail
