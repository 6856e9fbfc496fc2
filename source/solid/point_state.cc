#include <wheelrail/solid/point_state.h>

#include <algorithm>
#include <cmath>

// Stress and plastic strain at a point of an element, outside of the kernels, by the same laws
// (doc/manual/material.md, Theory).
//
// Stresses of output: force on the deformed area.

namespace wheelrail
{
  namespace
  {
    /// What one point remembers, out of the lanes of its batch.
    template <typename Law>
    typename Law::template History<Simd<1>>
    point_history(const Law &law, const ElementBlocks &blocks, const std::size_t element, const int point)
    {
      // zeros where the law has none
      typename Law::template History<Simd<1>> history(law);
      if constexpr (has_history<Law>)
        {
          const std::size_t W = blocks.width, batch = element / W, lane = element % W;
          // rows of the batch, then those of the points before this one
          const std::size_t   first = batch * blocks.history_rows() + law.history_rows() * point;
          std::vector<double> rows(law.history_rows());
          for (int row = 0; row < law.history_rows(); ++row)
            rows[row] = blocks.history[(first + row) * W + lane];
          history.load(rows.data());
        }
      return history;
    }
  } // namespace


  void
  point_stress(const ElementBlocks &blocks,
               const std::size_t    element,
               const int            point,
               const Simd<1> (&E)[6],
               Simd<1> (&S)[6])
  {
    const auto of_law = [&](const auto &law) {
      // S = K tr(E) 1 + 2 mu (dev E - E_p) (doc/manual/material.md, Theory)
      law.stress(E, point_history(law, blocks, element, point), S);
    };
    std::visit(of_law, blocks.law);
  }


  std::vector<double>
  element_plastic_strain(const ElementBlocks &blocks)
  {
    std::vector<double> strain(blocks.n_elements, 0.);
    const auto          of_law = [&](const auto &law) {
      using Law = std::decay_t<decltype(law)>;
      if constexpr (has_history<Law>)
        for (std::size_t e = 0; e < blocks.n_elements; ++e)
          // a = integral of sqrt(2/3 dE_p : dE_p), the largest of the points
          for (int point = 0; point < blocks.n_points(); ++point)
            {
              const auto history = point_history(law, blocks, e, point);
              strain[e]          = std::max<double>(strain[e], history.accumulated[0]);
            }
    };
    std::visit(of_law, blocks.law);
    return strain;
  }


  std::array<double, 6>
  cauchy_stress(const std::array<double, 9> &H, const Simd<1> (&S)[6])
  {
    // Voigt's order xx, yy, zz, yz, xz, xy; S is the second Piola-Kirchhoff stress
    const double s[3][3] = {
      {S[0][0], S[5][0], S[4][0]}, {S[5][0], S[1][0], S[3][0]}, {S[4][0], S[3][0], S[2][0]}};
    const double f[3][3] = {{H[0] + 1, H[1], H[2]}, {H[3], H[4] + 1, H[5]}, {H[6], H[7], H[8] + 1}};
    // dv/dV
    const double J = f[0][0] * (f[1][1] * f[2][2] - f[1][2] * f[2][1]) -
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
    // order xx, yy, zz, yz, xz, xy; of Cauchy stresses [Pa]
    const double a = s[0] - s[1], b = s[1] - s[2], c = s[2] - s[0];
    return std::sqrt(0.5 * (a * a + b * b + c * c) + 3 * (s[3] * s[3] + s[4] * s[4] + s[5] * s[5]));
  }
} // namespace wheelrail
