#pragma once

// The contact patch of two elastic half-spaces after Hertz (1882), as a finite element run with
// penalty contact would store it: for the tests of what is measured on patches.

#include <wheelrail/output/fields.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace test
{
  constexpr double hertz_peak     = 1.2e9;                    ///< peak pressure [Pa]
  constexpr double hertz_modulus  = 210e9 / (2 * (1 - 0.09)); ///< E* of steel on steel [Pa]
  constexpr double penalty_spring = 1.75e15;                  ///< contact stiffness [N/m3]

  /// Gap outside an elliptic contact with semi-axes a, b at (x, y) [m]: the surfaces' distance minus the
  /// displacement under the pressure p0 sqrt(1 - x^2/a^2 - y^2/b^2),
  ///   gap = p0 a b / (2 E*) int_0^l (x^2/(a^2+w) + y^2/(b^2+w) - 1) / sqrt((a^2+w)(b^2+w)w) dw,
  /// with l the largest root of x^2/(a^2+l) + y^2/(b^2+l) = 1 (K. L. Johnson, Contact Mechanics, 1985,
  /// section 3.3). Midpoint rule in sqrt(w).
  inline double
  hertz_gap(const double a, const double b, const double x, const double y)
  {
    const double p = a * a + b * b - x * x - y * y, q = a * a * b * b - x * x * b * b - y * y * a * a;
    const double upper = std::sqrt(std::max(0., (-p + std::sqrt(p * p - 4 * q)) / 2));
    const int    n     = 400;
    double       sum   = 0;
    for (int k = 0; k < n; ++k)
      {
        const double w = std::pow(upper * (k + 0.5) / n, 2);
        sum += 2 * upper / n * (x * x / (a * a + w) + y * y / (b * b + w) - 1) /
               std::sqrt((a * a + w) * (b * b + w));
      }
    return hertz_peak * a * b / (2 * hertz_modulus) * sum;
  }

  /// Hertz's patch on a grid of cells h, shifted by the fractions u, v of a cell, with the full slip
  /// traction 0.3 p against the rolling direction; the leading half is marked as sticking.
  inline wheelrail::PatchFields
  hertz_patch(const double a, const double b, const double h, const double u, const double v)
  {
    wheelrail::PatchFields patch;
    const int              n = int(a / h) + 4, m = int(b / h) + 4;
    patch.time = 0.0125, patch.rolled_distance = 0.05;
    patch.n_along = 2 * n + 1, patch.n_lateral = 2 * m + 1;
    for (int i = -n; i <= n; ++i)
      for (int j = -m; j <= m; ++j)
        {
          const double x = (i + u) * h, y = (j + v) * h, r = 1 - x * x / (a * a) - y * y / (b * b);
          const double p = r > 0 ? hertz_peak * std::sqrt(r) : 0;
          patch.along.push_back(x);
          patch.lateral.push_back(y);
          patch.gap.push_back(r > 0 ? -p / penalty_spring : hertz_gap(a, b, x, y));
          patch.pressure.push_back(p);
          patch.traction_along.push_back(-0.3 * p);
          patch.traction_lateral.push_back(0);
          patch.slip_along.push_back(p > 0 && x < 0 ? 2e-3 : 0);
          patch.slip_lateral.push_back(0);
          patch.state.push_back(p > 0 ? (x < 0 ? 2 : 1) : 0);
          patch.area.push_back(h * h);
        }
    return patch;
  }

  /// The same patch twice, side by side across the rail.
  inline wheelrail::PatchFields
  two_patches(const wheelrail::PatchFields &one)
  {
    using Field                = std::vector<double> wheelrail::PatchFields::*;
    using P                    = wheelrail::PatchFields;
    wheelrail::PatchFields two = one;
    two.n_lateral              = 2 * one.n_lateral;
    const double shift = one.lateral[one.n_lateral - 1] - one.lateral[0] + one.lateral[1] - one.lateral[0];
    for (const Field field : {&P::along,
                              &P::lateral,
                              &P::gap,
                              &P::pressure,
                              &P::traction_along,
                              &P::traction_lateral,
                              &P::slip_along,
                              &P::slip_lateral,
                              &P::state,
                              &P::area})
      {
        (two.*field).clear();
        for (unsigned int i = 0; i < one.n_along; ++i)
          for (unsigned int j = 0; j < two.n_lateral; ++j)
            (two.*field)
              .push_back((one.*field)[i * one.n_lateral + j % one.n_lateral] +
                         (field == &P::lateral && j >= one.n_lateral ? shift : 0));
      }
    return two;
  }
} // namespace test
