#include <wheelrail/solid/full_element.h>
#include <wheelrail/solid/reduced_element.h>

#include <array>

// Exact linearisation at rest of the reduced element's force, K = V B'D B + stabilisation
// (doc/theory/element.md): of the centre by Hooke's law, of the patterns by the kernel's own law, so that
// static start and time loop have one equilibrium.

namespace wheelrail
{
  namespace
  {
    using Vector = std::array<double, 3>;

    /// Signs of the patterns eta zeta, zeta xi, xi eta, xi eta zeta at the lexicographic nodes.
    constexpr int pattern[8][4] = {{1, 1, 1, -1},
                                   {1, -1, -1, 1},
                                   {-1, 1, -1, 1},
                                   {-1, -1, 1, -1},
                                   {-1, -1, 1, 1},
                                   {-1, 1, -1, -1},
                                   {1, -1, -1, -1},
                                   {1, 1, 1, 1}};

    /// Hourglass stresses of the amplitudes p in the cell's axes, by the law of the kernel.
    std::array<Vector, 4>
    hourglass_law(const ElementGeometry &g, const Elasticity &material, const std::array<Vector, 4> &p)
    {
      // Q is linear in p: W = (1/2) p . Q(p), so that calling the kernel's law with unit amplitudes gives its
      // matrix
      double rows[ElementBlocks::fields] = {};
      for (int k = 0; k < 3; ++k)
        rows[reduced::inverse_half_row + k] = reduced::scaled_inverse_half(g.volume, g.half[k]);
      V3<1>   amplitudes[4], stresses[4];
      Simd<1> square;
      for (int m = 0; m < 4; ++m)
        for (int k = 0; k < 3; ++k)
          amplitudes[m][k] = p[m][k];
      // Q_m = dW/dp_m: plates in bending and twist, bars in the last pattern (doc/theory/element.md, table of
      // Stabilisation)
      reduced::hourglass_stress<1>({rows}, amplitudes, material, stresses, square);
      std::array<Vector, 4> Q;
      for (int m = 0; m < 4; ++m)
        for (int k = 0; k < 3; ++k)
          Q[m][k] = stresses[m][k][0];
      return Q;
    }

    /// gamma_m(a) = h_m(a) - B_a . (h_m X).
    std::array<std::array<double, 4>, 8>
    blind_patterns(const ElementGeometry &g)
    {
      // gamma_m is orthogonal to all linear fields (Flanagan and Belytschko 1981): sum over a of gamma_m(a) =
      // 0 and sum of gamma_m(a) X_a = 0, so that these have no stabilisation energy
      std::array<std::array<double, 4>, 8> gamma;
      for (int a = 0; a < 8; ++a)
        for (int m = 0; m < 4; ++m)
          {
            // at rest q_m = sum over a of gamma_m(a) u_a: the pattern less what a linear field has of it
            gamma[a][m] = pattern[a][m];
            for (int i = 0; i < 3; ++i)
              gamma[a][m] -= g.B[a][i] * g.hX[m][i];
          }
      return gamma;
    }

    /// Stress of a displacement gradient that has only row i: grad = e_i (x) b.
    std::array<Vector, 3>
    stress_of_row(const Elasticity &material, const int i, const Vector &b)
    {
      const double          mu = material.shear_modulus();
      std::array<Vector, 3> S{};
      for (int k = 0; k < 3; ++k)
        {
          // S = lambda tr(e) I + 2 mu e, e = (grad + grad')/2
          S[i][k] += mu * b[k];
          S[k][i] += mu * b[k];
          S[k][k] += material.lame_lambda() * b[i];
        }
      return S;
    }
  } // namespace


  std::array<double, 24 * 24>
  element_stiffness(const ElementGeometry &g, const Elasticity &material, const ElementForm form)
  {
    if (form == ElementForm::full)
      return full_element_stiffness(g.vertices, material);
    std::array<double, 24 * 24> K{};
    const auto                  gamma = blind_patterns(g);
    for (int b = 0; b < 8; ++b)
      for (int j = 0; j < 3; ++j)
        {
          // column (b, j): stresses and patterns of a unit displacement of node b along j
          const auto            S = stress_of_row(material, j, g.B[b]);
          std::array<Vector, 4> p, Q;
          for (int m = 0; m < 4; ++m)
            for (int k = 0; k < 3; ++k)
              // p_m = A' q_m: F = 1 at rest
              p[m][k] = gamma[b][m] * g.frame[k][j];
          Q = hourglass_law(g, material, p);
          std::array<Vector, 4> G{};
          for (int m = 0; m < 4; ++m)
            for (int k = 0; k < 3; ++k)
              for (int i = 0; i < 3; ++i)
                // G_m = A Q_m
                G[m][i] += g.frame[k][i] * Q[m][k];
          for (int a = 0; a < 8; ++a)
            for (int i = 0; i < 3; ++i)
              {
                double value = 0;
                for (int k = 0; k < 3; ++k)
                  // force_a = V S B_a + sum over m of gamma_m(a) G_m: at rest the terms with q_m and F - 1
                  // are of second order
                  value += g.volume * S[i][k] * g.B[a][k];
                for (int m = 0; m < 4; ++m)
                  value += gamma[a][m] * G[m][i];
                K[24 * (3 * a + i) + 3 * b + j] = value;
              }
        }
    return K;
  }
} // namespace wheelrail
