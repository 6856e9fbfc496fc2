#include <wheelrail/halfspace/kalker_coefficients.h>

#include <algorithm>
#include <array>
#include <cstddef>

// Creep coefficients C11, C22, C23 of Kalker (1967; table E3 of Kalker 1990): Fx = -G a b C11 xi, Fy = -G a b
// (C22 eta + sqrt(a b) C23 phi), a along rolling. The theory is linear: no slip, small creepages.

namespace wheelrail
{
  namespace
  {
    // over the smaller semi-axis divided by the larger one, 0.1 to 1, for Poisson's ratios 0, 1/4, 1/2
    using Table                = std::array<std::array<double, 3>, 10>;
    constexpr Table c11_narrow = {{{{2.51, 3.31, 4.85}},
                                   {{2.59, 3.37, 4.81}},
                                   {{2.68, 3.44, 4.8}},
                                   {{2.78, 3.53, 4.82}},
                                   {{2.88, 3.62, 4.83}},
                                   {{2.98, 3.72, 4.91}},
                                   {{3.09, 3.81, 4.97}},
                                   {{3.19, 3.91, 5.05}},
                                   {{3.29, 4.01, 5.12}},
                                   {{3.4, 4.12, 5.2}}}};
    constexpr Table c11_long   = {{{{10.7, 11.7, 12.9}},
                                   {{6.96, 7.78, 8.82}},
                                   {{5.57, 6.34, 7.34}},
                                   {{4.84, 5.57, 6.57}},
                                   {{4.37, 5.1, 6.11}},
                                   {{4.06, 4.78, 5.8}},
                                   {{3.82, 4.54, 5.58}},
                                   {{3.65, 4.36, 5.42}},
                                   {{3.51, 4.22, 5.3}},
                                   {{3.4, 4.12, 5.2}}}};
    constexpr Table c22_narrow = {{{{2.51, 2.52, 2.53}},
                                   {{2.59, 2.63, 2.66}},
                                   {{2.68, 2.75, 2.81}},
                                   {{2.78, 2.88, 2.98}},
                                   {{2.88, 3.01, 3.14}},
                                   {{2.98, 3.14, 3.31}},
                                   {{3.09, 3.28, 3.48}},
                                   {{3.19, 3.41, 3.65}},
                                   {{3.29, 3.54, 3.82}},
                                   {{3.4, 3.67, 3.98}}}};
    constexpr Table c22_long   = {{{{10.7, 12.8, 16}},
                                   {{6.96, 8.14, 9.79}},
                                   {{5.57, 6.4, 7.51}},
                                   {{4.84, 5.48, 6.31}},
                                   {{4.37, 4.9, 5.56}},
                                   {{4.06, 4.5, 5.04}},
                                   {{3.82, 4.21, 4.67}},
                                   {{3.65, 3.99, 4.39}},
                                   {{3.51, 3.81, 4.16}},
                                   {{3.4, 3.67, 3.98}}}};
    constexpr Table c23_narrow = {{{{0.334, 0.473, 0.731}},
                                   {{0.483, 0.603, 0.809}},
                                   {{0.607, 0.715, 0.889}},
                                   {{0.72, 0.823, 0.977}},
                                   {{0.827, 0.929, 1.07}},
                                   {{0.93, 1.03, 1.18}},
                                   {{1.03, 1.14, 1.29}},
                                   {{1.13, 1.25, 1.4}},
                                   {{1.23, 1.36, 1.51}},
                                   {{1.33, 1.47, 1.63}}}};
    constexpr Table c23_long   = {{{{12.2, 14.6, 18}},
                                   {{5.72, 6.63, 7.89}},
                                   {{3.79, 4.32, 5.01}},
                                   {{2.88, 3.24, 3.7}},
                                   {{2.35, 2.62, 2.96}},
                                   {{2.01, 2.23, 2.5}},
                                   {{1.76, 1.95, 2.18}},
                                   {{1.58, 1.75, 1.94}},
                                   {{1.44, 1.59, 1.77}},
                                   {{1.33, 1.47, 1.63}}}};

    double
    between(const Table &table, const double ratio, const double poisson)
    {
      // rows at 0.1, 0.2, ... 1; beyond 0.1 the end of the table
      const double      place = std::clamp(10 * ratio - 1, 0., 9.);
      const std::size_t k     = std::min<std::size_t>(8, static_cast<std::size_t>(place));
      const double      t     = place - double(k);
      // Lagrange's parabola through nu = 0, 1/4 and 1/2, linear between two ratios of the axes
      const double share[3] = {8 * (poisson - 0.25) * (poisson - 0.5),
                               -16 * poisson * (poisson - 0.5),
                               8 * poisson * (poisson - 0.25)};
      double       sum      = 0;
      for (std::size_t n = 0; n < 3; ++n)
        sum += share[n] * (table[k][n] + t * (table[k + 1][n] - table[k][n]));
      return sum;
    }
  } // namespace


  KalkerCoefficients
  kalker_coefficients(const double ratio, const double poisson_ratio)
  {
    // narrow: short along rolling, a <= b; at a = b both tables agree
    const bool   is_narrow = ratio <= 1;
    const double g         = is_narrow ? ratio : 1 / ratio;
    // [-]; forces on body 1 are against the creepage
    return {between(is_narrow ? c11_narrow : c11_long, g, poisson_ratio),
            between(is_narrow ? c22_narrow : c22_long, g, poisson_ratio),
            between(is_narrow ? c23_narrow : c23_long, g, poisson_ratio)};
  }
} // namespace wheelrail
