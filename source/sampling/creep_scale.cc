#include <wheelrail/sampling/creep_scale.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace wheelrail
{
  namespace
  {
    /// Kalker's coefficients over the smaller semi-axis divided by the larger one, 0.1 to 1, for a Poisson's
    /// ratio of 1/4 (Kalker 1967, table of On the rolling contact of two elastic bodies in the presence of
    /// dry friction); at 0.3 they are some 3 % larger.
    constexpr std::array<double, 10> c11_narrow =
      {3.31, 3.37, 3.44, 3.53, 3.62, 3.72, 3.81, 3.91, 4.01, 4.12};
    constexpr std::array<double, 10> c22_narrow =
      {2.52, 2.63, 2.75, 2.88, 3.01, 3.14, 3.28, 3.41, 3.54, 3.67};
    constexpr std::array<double, 10> c11_long = {11.7, 7.78, 6.34, 5.57, 5.10, 4.78, 4.54, 4.36, 4.22, 4.12};
    constexpr std::array<double, 10> c22_long = {12.8, 8.14, 6.40, 5.48, 4.90, 4.50, 4.21, 3.99, 3.81, 3.67};

    double
    between(const std::array<double, 10> &table, const double ratio)
    {
      const double      place = std::clamp(10 * ratio - 1, 0., 9.);
      const std::size_t k     = std::min<std::size_t>(8, static_cast<std::size_t>(place));
      return table[k] + (place - double(k)) * (table[k + 1] - table[k]);
    }
  } // namespace


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
    const double a = 0.5 * length, b = 0.5 * width;
    const bool   is_narrow = a <= b;
    const double ratio     = is_narrow ? a / b : b / a;
    return {friction_bound,
            shear_modulus * a * b * between(is_narrow ? c11_narrow : c11_long, ratio),
            shear_modulus * a * b * between(is_narrow ? c22_narrow : c22_long, ratio)};
  }
} // namespace wheelrail
