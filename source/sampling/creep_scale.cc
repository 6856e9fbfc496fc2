#include <wheelrail/halfspace/kalker_coefficients.h>
#include <wheelrail/sampling/creep_scale.h>

#include <algorithm>
#include <cmath>

namespace wheelrail
{
  double
  CreepScale::half_saturation() const
  {
    // F = bound (1 - (1 - c/c_s)^3) with the slope 3 bound/c_s at c = 0
    return (1 - std::cbrt(0.5)) * 3 * friction_bound / stiffness;
  }


  double
  CreepScale::tangent(const double force) const
  {
    const double left = std::max(0., 1 - std::abs(force) / friction_bound);
    return std::pow(left, 2. / 3);
  }


  CreepScale
  creep_scale(const double friction_bound,
              const double shear_modulus,
              const double length,
              const double width)
  {
    // at a ratio of 0.3 instead of 1/4 they are some 3 % larger
    const double             a = 0.5 * length, b = 0.5 * width;
    const KalkerCoefficients c = kalker_coefficients(a / b, 0.25);
    return {friction_bound, shear_modulus * a * b * c.c11, shear_modulus * a * b * c.c22};
  }
} // namespace wheelrail
