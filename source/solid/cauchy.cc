#include <wheelrail/solid/cauchy.h>

#include <cmath>

// Stresses of output: force on the deformed area.

namespace wheelrail
{
  std::array<double, 6>
  cauchy_stress(const std::array<double, 9> &H, const Simd<1> (&S)[6])
  {
    // Voigt's order xx, yy, zz, yz, xz, xy; S is the second Piola-Kirchhoff stress
    const double s[3][3] = {
      {S[0][0], S[5][0], S[4][0]}, {S[5][0], S[1][0], S[3][0]}, {S[4][0], S[3][0], S[2][0]}};
    const double f[3][3] = {{H[0] + 1, H[1], H[2]}, {H[3], H[4] + 1, H[5]}, {H[6], H[7], H[8] + 1}};
    const double J       = f[0][0] * (f[1][1] * f[2][2] - f[1][2] * f[2][1]) -
                     f[0][1] * (f[1][0] * f[2][2] - f[1][2] * f[2][0]) +
                     f[0][2] * (f[1][0] * f[2][1] - f[1][1] * f[2][0]);
    constexpr int row[6] = {0, 1, 2, 1, 0, 0}, column[6] = {0, 1, 2, 2, 2, 1};
    // sigma = F S F' / J with F = 1 + H
    std::array<double, 6> result{};
    for (int k = 0; k < 6; ++k)
      {
        for (int i = 0; i < 3; ++i)
          for (int j = 0; j < 3; ++j)
            result[k] += f[row[k]][i] * s[i][j] * f[column[k]][j];
        result[k] /= J;
      }
    return result;
  }


  double
  von_mises(const double *s)
  {
    // sqrt(3/2 dev s : dev s) (von Mises)
    const double a = s[0] - s[1], b = s[1] - s[2], c = s[2] - s[0];
    return std::sqrt(0.5 * (a * a + b * b + c * c) + 3 * (s[3] * s[3] + s[4] * s[4] + s[5] * s[5]));
  }
} // namespace wheelrail
