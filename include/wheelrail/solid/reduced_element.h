#pragma once

#include <wheelrail/material/elasticity.h>
#include <wheelrail/solid/lanes.h>

#include <cmath>
#include <cstdint>

// The parts of the `reduced` hexahedron for W elements at once, as inline functions for its kernels;
// see doc/theory/element.md.

namespace wheelrail::reduced
{
  constexpr int inverse_half_row = 46; ///< first of the three rows of scaled_inverse_half

  /// The factor from hourglass amplitudes [m] to strains at the faces, times sqrt(V / 3) [m^1/2]: the square
  /// of (1/8 h.u / half) V/3 integrates a linear strain over the cell, see doc/theory/element.md. `half`:
  /// half edge length [m].
  inline double
  scaled_inverse_half(const double volume, const double half)
  {
    return std::sqrt(volume / 3) / (8 * half);
  }

  /// Packed geometry of one batch, loaded row by row.
  template <int W>
  struct Packed
  {
    const double *data;

    Simd<W>
    row(const int field) const
    {
      return Simd<W>(data + field * W, std::experimental::vector_aligned);
    }
    Simd<W>
    B(const int a, const int i) const
    {
      return row(3 * a + i);
    }
    Simd<W>
    volume() const
    {
      return row(24);
    }
    Simd<W>
    hX(const int m, const int i) const
    {
      return row(25 + 3 * m + i);
    }
    Simd<W>
    axis(const int k, const int i) const
    {
      return row(37 + 3 * k + i);
    }
    Simd<W>
    inverse_half(const int k) const
    {
      return row(inverse_half_row + k);
    }
    Simd<W>
    length() const
    {
      return row(49);
    }
  };

  // ---- phase 1: displacement gradient and hourglass amplitudes ----

  /// Sums of the nodal values times the four hourglass patterns, by two levels of sums and
  /// differences over the lexicographic nodes.
  template <int W>
  [[gnu::always_inline]] inline void
  hourglass_sums(const V3<W> (&u)[8], const int i, Simd<W> (&s)[4])
  {
    // differences and sums along xi
    const Simd<W> d0 = u[1][i] - u[0][i], d1 = u[3][i] - u[2][i], d2 = u[5][i] - u[4][i],
                  d3 = u[7][i] - u[6][i];
    const Simd<W> e0 = u[1][i] + u[0][i], e1 = u[3][i] + u[2][i], e2 = u[5][i] + u[4][i],
                  e3 = u[7][i] + u[6][i];
    s[0]             = (e3 - e2) - (e1 - e0); // eta zeta
    s[1]             = (d3 + d2) - (d1 + d0); // zeta xi
    s[2]             = (d3 - d2) + (d1 - d0); // xi eta
    s[3]             = (d3 - d2) - (d1 - d0); // xi eta zeta
  }

  /// H = sum u_a (x) B_a and q_m = sum h_m u - H (h_m X).
  template <int W>
  [[gnu::always_inline]] inline void
  gradients(const Packed<W> &g, const V3<W> (&u)[8], V3<W> (&H)[3], V3<W> (&q)[4])
  {
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        {
          Simd<W> h = u[0][i] * g.B(0, j);
          for (int a = 1; a < 8; ++a)
            h += u[a][i] * g.B(a, j);
          H[i][j] = h;
        }
    for (int i = 0; i < 3; ++i)
      {
        Simd<W> s[4];
        hourglass_sums<W>(u, i, s);
        for (int m = 0; m < 4; ++m)
          q[m][i] = s[m] - H[i][0] * g.hX(m, 0) - H[i][1] * g.hX(m, 1) - H[i][2] * g.hX(m, 2);
      }
  }

  // ---- phase 2: strain and stress of the one-point field ----

  /// Green's strain, xx, yy, zz, yz, xz, xy.
  template <int W>
  [[gnu::always_inline]] inline void
  green_strain(const V3<W> (&H)[3], Simd<W> (&E)[6])
  {
    constexpr int row[6] = {0, 1, 2, 1, 0, 0}, column[6] = {0, 1, 2, 2, 2, 1};
    for (int k = 0; k < 6; ++k)
      {
        const int i = row[k], j = column[k];
        E[k] = 0.5 * (H[i][j] + H[j][i] + H[0][i] * H[0][j] + H[1][i] * H[1][j] + H[2][i] * H[2][j]);
      }
  }

  /// V F S: the nodal force is this times the mean gradient, without the stabilisation.
  template <int W>
  [[gnu::always_inline]] inline void
  force_of_stress(const Packed<W> &g, const V3<W> (&F)[3], const Simd<W> (&S)[6], V3<W> (&P)[3])
  {
    for (int i = 0; i < 3; ++i)
      {
        P[i][0] = g.volume() * (F[i][0] * S[0] + F[i][1] * S[5] + F[i][2] * S[4]);
        P[i][1] = g.volume() * (F[i][0] * S[5] + F[i][1] * S[1] + F[i][2] * S[3]);
        P[i][2] = g.volume() * (F[i][0] * S[4] + F[i][1] * S[3] + F[i][2] * S[2]);
      }
  }

  // ---- phase 3: hourglass stresses ----

  /// Amplitudes in the cell's axes carried along by F: p = (F A)^T q, a Green-type measure. FA[k] is
  /// the axis k.
  template <int W>
  [[gnu::always_inline]] inline void
  hourglass_amplitudes(const Packed<W> &g,
                       const V3<W> (&F)[3],
                       const V3<W> (&q)[4],
                       V3<W> (&FA)[3],
                       V3<W> (&p)[4])
  {
    for (int i = 0; i < 3; ++i)
      for (int k = 0; k < 3; ++k)
        FA[k][i] = F[i][0] * g.axis(k, 0) + F[i][1] * g.axis(k, 1) + F[i][2] * g.axis(k, 2);
    for (int m = 0; m < 4; ++m)
      for (int k = 0; k < 3; ++k)
        p[m][k] = FA[k][0] * q[m][0] + FA[k][1] * q[m][1] + FA[k][2] * q[m][2];
  }

  /// Generalised stresses Q of the hourglass amplitudes p given in the axes of the cell, and their
  /// energy.
  ///
  /// The strain varies linearly over the cell. Along the k axis the two strains across it vary as
  /// in a bent plate whose stress along k vanishes, which makes rectangular cells bend exactly; the
  /// shear strains keep their twisting parts only; the last pattern has the stiffness of a bar.
  /// `square` becomes V/3 times the summed squares of von Mises' equivalent of the plates' stresses at
  /// the faces, bars counting 4/9 (they bear 9/4 of their elastic limit when fully plastic, plates
  /// 3/2).
  template <int W>
  [[gnu::always_inline]] inline Simd<W>
  hourglass_stress(const Packed<W> &g,
                   const V3<W> (&p)[4],
                   const Elasticity &material,
                   V3<W> (&Q)[4],
                   Simd<W> &square)
  {
    const double  youngs_modulus = material.youngs_modulus, nu = material.poissons_ratio;
    const double  mu    = material.shear_modulus();
    const double  plate = youngs_modulus / (1 - nu * nu);
    const Simd<W> c[3]  = {g.inverse_half(0), g.inverse_half(1), g.inverse_half(2)};
    Simd<W>       energy(0.);
    square = 0.;
    for (int m = 0; m < 3; ++m)
      for (int i = 0; i < 3; ++i)
        Q[m][i] = Simd<W>(0.);
    for (int k = 0; k < 3; ++k)
      {
        // pattern m lacks the coordinate m: the strain along i varies with k in the pattern 3 - i - k
        const int     i = (k + 1) % 3, j = (k + 2) % 3;
        const Simd<W> ei = p[j][i] * c[i], ej = p[i][j] * c[j];
        const Simd<W> si = plate * (ei + nu * ej), sj = plate * (ej + nu * ei);
        Q[j][i] += si * c[i];
        Q[i][j] += sj * c[j];
        // twist: the shear strain of i and j varies with k in the patterns i and j
        const Simd<W> twist = p[i][i] * c[j] + p[j][j] * c[i];
        const Simd<W> shear = mu * twist;
        Q[i][i] += shear * c[j];
        Q[j][j] += shear * c[i];
        const Simd<W> bar = p[3][k] * c[k];
        const Simd<W> sb  = (youngs_modulus / 3) * bar;
        Q[3][k]           = sb * c[k];
        square += si * si - si * sj + sj * sj + 3. * shear * shear + 4. * sb * sb;
        energy += 0.5 * (si * ei + sj * ej + shear * twist + sb * bar);
      }
    return energy;
  }

  // ---- phase 4: nodal forces ----

  /// The derivative of the stabilisation energy by q becomes G, the one by F is added to P.
  template <int W>
  [[gnu::always_inline]] inline void
  hourglass_forces(const Packed<W> &g,
                   const V3<W> (&FA)[3],
                   const V3<W> (&q)[4],
                   const V3<W> (&Q)[4],
                   V3<W> (&P)[3],
                   V3<W> (&G)[4])
  {
    for (int m = 0; m < 4; ++m)
      {
        V3<W> AQ;
        for (int i = 0; i < 3; ++i)
          {
            G[m][i] = FA[0][i] * Q[m][0] + FA[1][i] * Q[m][1] + FA[2][i] * Q[m][2];
            AQ[i]   = g.axis(0, i) * Q[m][0] + g.axis(1, i) * Q[m][1] + g.axis(2, i) * Q[m][2];
          }
        for (int i = 0; i < 3; ++i)
          for (int j = 0; j < 3; ++j)
            P[i][j] += q[m][i] * AQ[j] - G[m][i] * g.hX(m, j);
      }
  }

  /// f_a = P B_a + sum_m h_m(a) g_m, subtracted from the node array.
  template <int W>
  [[gnu::always_inline]] inline void
  apply_forces(const Packed<W>     &g,
               const std::uint32_t *nodes,
               const V3<W> (&P)[3],
               const V3<W> (&G)[4],
               double *force)
  {
    V3<W> f[8];
    for (int i = 0; i < 3; ++i)
      {
        const Simd<W> g0 = G[0][i], g1 = G[1][i], g2 = G[2][i], g3 = G[3][i];
        const Simd<W> a = g0 + g1, b = g0 - g1, c = g2 + g3, d = g2 - g3;
        // signs of (eta zeta, zeta xi, xi eta, xi eta zeta) at the lexicographic nodes
        const Simd<W> h[8] = {a + d, b - d, -b - d, d - a, c - a, -b - c, b - c, a + c};
        for (int n = 0; n < 8; ++n)
          f[n][i] = P[i][0] * g.B(n, 0) + P[i][1] * g.B(n, 1) + P[i][2] * g.B(n, 2) + h[n];
      }
    for (int n = 0; n < 8; ++n)
      scatter_subtract<W>(force, nodes + n * W, f[n]);
  }

} // namespace wheelrail::reduced
