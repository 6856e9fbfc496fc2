#include <wheelrail/solid/kernel.h>

#include <cmath>

namespace wheelrail
{
  namespace
  {
    namespace stdx = std::experimental;

    typedef double Four __attribute__((vector_size(32), aligned(32)));

    /// Three vectors of W lanes.
    template <int W>
    using V3 = Simd<W>[3];

    // ---- phase 0: moving nodal values between the node arrays and the lanes ----

    /// Loads the node vectors of W elements and turns them into one vector a component.
    template <int W>
    inline void
    gather(const double *array, const std::uint32_t *node, V3<W> &value)
    {
      alignas(64) double buffer[3][W];
      if constexpr (W >= 4)
        for (int l = 0; l < W; l += 4)
          {
            const Four r0 = *reinterpret_cast<const Four *>(array + 4 * node[l]);
            const Four r1 = *reinterpret_cast<const Four *>(array + 4 * node[l + 1]);
            const Four r2 = *reinterpret_cast<const Four *>(array + 4 * node[l + 2]);
            const Four r3 = *reinterpret_cast<const Four *>(array + 4 * node[l + 3]);
            const Four t0 = __builtin_shufflevector(r0, r1, 0, 4, 2, 6);
            const Four t1 = __builtin_shufflevector(r0, r1, 1, 5, 3, 7);
            const Four t2 = __builtin_shufflevector(r2, r3, 0, 4, 2, 6);
            const Four t3 = __builtin_shufflevector(r2, r3, 1, 5, 3, 7);
            *reinterpret_cast<Four *>(&buffer[0][l]) = __builtin_shufflevector(t0, t2, 0, 1, 4, 5);
            *reinterpret_cast<Four *>(&buffer[1][l]) = __builtin_shufflevector(t1, t3, 0, 1, 4, 5);
            *reinterpret_cast<Four *>(&buffer[2][l]) = __builtin_shufflevector(t0, t2, 2, 3, 6, 7);
          }
      else
        for (int l = 0; l < W; ++l)
          for (int i = 0; i < 3; ++i)
            buffer[i][l] = array[4 * node[l] + i];
      for (int i = 0; i < 3; ++i)
        value[i].copy_from(buffer[i], stdx::vector_aligned);
    }

    /// Subtracts the lanes from the node vectors, one element after the other since neighbours in a
    /// batch share nodes.
    template <int W>
    inline void
    scatter_subtract(double *array, const std::uint32_t *node, const V3<W> &value)
    {
      alignas(64) double buffer[3][W];
      for (int i = 0; i < 3; ++i)
        value[i].copy_to(buffer[i], stdx::vector_aligned);
      if constexpr (W >= 4)
        for (int l = 0; l < W; l += 4)
          {
            const Four x    = *reinterpret_cast<const Four *>(&buffer[0][l]);
            const Four y    = *reinterpret_cast<const Four *>(&buffer[1][l]);
            const Four z    = *reinterpret_cast<const Four *>(&buffer[2][l]);
            const Four zero = {0, 0, 0, 0};
            const Four t0   = __builtin_shufflevector(x, y, 0, 4, 2, 6);
            const Four t1   = __builtin_shufflevector(x, y, 1, 5, 3, 7);
            const Four t2   = __builtin_shufflevector(z, zero, 0, 4, 2, 6);
            const Four t3   = __builtin_shufflevector(z, zero, 1, 5, 3, 7);
            *reinterpret_cast<Four *>(array + 4 * node[l]) -= __builtin_shufflevector(t0, t2, 0, 1, 4, 5);
            *reinterpret_cast<Four *>(array + 4 * node[l + 1]) -= __builtin_shufflevector(t1, t3, 0, 1, 4, 5);
            *reinterpret_cast<Four *>(array + 4 * node[l + 2]) -= __builtin_shufflevector(t0, t2, 2, 3, 6, 7);
            *reinterpret_cast<Four *>(array + 4 * node[l + 3]) -= __builtin_shufflevector(t1, t3, 2, 3, 6, 7);
          }
      else
        for (int l = 0; l < W; ++l)
          for (int i = 0; i < 3; ++i)
            array[4 * node[l] + i] -= buffer[i][l];
    }

    /// Packed geometry of one batch, loaded row by row.
    template <int W>
    struct Packed
    {
      const double *data;

      Simd<W>
      row(const int field) const
      {
        return Simd<W>(data + field * W, stdx::vector_aligned);
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
        return row(46 + k);
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
    inline void
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
    inline void
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

    // ---- phase 2: stress of the one-point field ----

    /// Green's strain E and second Piola-Kirchhoff stress S, both xx, yy, zz, yz, xz, xy.
    template <int W>
    inline void
    stress(const V3<W> (&H)[3], const double lambda, const double mu, Simd<W> (&E)[6], Simd<W> (&S)[6])
    {
      constexpr int row[6] = {0, 1, 2, 1, 0, 0}, column[6] = {0, 1, 2, 2, 2, 1};
      for (int k = 0; k < 6; ++k)
        {
          const int i = row[k], j = column[k];
          E[k] = 0.5 * (H[i][j] + H[j][i] + H[0][i] * H[0][j] + H[1][i] * H[1][j] + H[2][i] * H[2][j]);
        }
      const Simd<W> pressure = lambda * (E[0] + E[1] + E[2]);
      for (int k = 0; k < 6; ++k)
        S[k] = 2 * mu * E[k] + (k < 3 ? pressure : Simd<W>(0.));
    }

    // ---- phase 3: hourglass stresses ----

    /// Generalised stresses Q of the hourglass amplitudes p given in the axes of the cell.
    ///
    /// The strain varies linearly over the cell. Along the k axis the two strains across it vary as
    /// in a bent plate whose stress along k vanishes, which makes rectangular cells bend exactly; the
    /// shear strains keep their twisting parts only; the last pattern has the stiffness of a bar.
    template <int W>
    inline Simd<W>
    hourglass_stress(const Packed<W> &g,
                     const V3<W> (&p)[4],
                     const double youngs_modulus,
                     const double nu,
                     V3<W> (&Q)[4])
    {
      const double  mu    = youngs_modulus / (2 * (1 + nu));
      const double  plate = youngs_modulus / (1 - nu * nu);
      const Simd<W> c[3]  = {g.inverse_half(0), g.inverse_half(1), g.inverse_half(2)};
      Simd<W>       energy(0.);
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
          energy += 0.5 * (si * ei + sj * ej + shear * twist + sb * bar);
        }
      return energy;
    }

    // ---- phase 4: nodal forces ----

    /// f_a = P B_a + sum_m h_m(a) g_m, subtracted from the node array.
    template <int W>
    inline void
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

    /// Energies summed lane by lane.
    template <int W>
    struct LaneEnergy
    {
      Simd<W> strain = 0., stabilisation = 0., viscous_power = 0.;
    };

    /// The work of one batch.
    template <int W, bool with_energy>
    inline void
    batch_force(ElementBlocks       &blocks,
                const std::size_t    batch,
                const double        *displacement,
                double              *force,
                const BulkViscosity &viscosity,
                LaneEnergy<W>       &energy)
    {
      const Elasticity    &material = blocks.material;
      const std::uint32_t *nodes    = blocks.nodes.data() + batch * 8 * W;
      const Packed<W>      g{blocks.data.data() + batch * ElementBlocks::fields * W};

      V3<W> u[8];
      for (int a = 0; a < 8; ++a)
        gather<W>(displacement, nodes + a * W, u[a]);
      V3<W> H[3], q[4];
      gradients<W>(g, u, H, q);

      Simd<W> E[6], S[6];
      stress<W>(H, material.lame_lambda(), material.shear_modulus(), E, S);
      if constexpr (with_energy)
        {
          const Simd<W> density =
            0.5 * (S[0] * E[0] + S[1] * E[1] + S[2] * E[2]) + S[3] * E[3] + S[4] * E[4] + S[5] * E[5];
          energy.strain += g.volume() * density;
        }
      if (viscosity.time_step > 0)
        {
          double       *old  = blocks.dilatation.data() + batch * W;
          const Simd<W> now  = E[0] + E[1] + E[2];
          const Simd<W> rate = (now - Simd<W>(old, stdx::vector_aligned)) / viscosity.time_step;
          now.copy_to(old, stdx::vector_aligned);
          const double  factor = viscosity.coefficient * material.density * material.wave_speed();
          const Simd<W> extra  = factor * g.length() * rate;
          for (int k = 0; k < 3; ++k)
            S[k] += extra;
          energy.viscous_power += g.volume() * extra * rate;
        }

      V3<W> F[3], P[3];
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
          F[i][j] = i == j ? H[i][j] + 1. : H[i][j];
      for (int i = 0; i < 3; ++i)
        {
          P[i][0] = g.volume() * (F[i][0] * S[0] + F[i][1] * S[5] + F[i][2] * S[4]);
          P[i][1] = g.volume() * (F[i][0] * S[5] + F[i][1] * S[1] + F[i][2] * S[3]);
          P[i][2] = g.volume() * (F[i][0] * S[4] + F[i][1] * S[3] + F[i][2] * S[2]);
        }

      // amplitudes in the cell's axes carried along by F: p = (F A)^T q, a Green-type measure
      V3<W> FA[3], p[4], Q[4], G[4];
      for (int i = 0; i < 3; ++i)
        for (int k = 0; k < 3; ++k)
          FA[k][i] = F[i][0] * g.axis(k, 0) + F[i][1] * g.axis(k, 1) + F[i][2] * g.axis(k, 2);
      for (int m = 0; m < 4; ++m)
        for (int k = 0; k < 3; ++k)
          p[m][k] = FA[k][0] * q[m][0] + FA[k][1] * q[m][1] + FA[k][2] * q[m][2];
      const Simd<W> hourglass_energy =
        hourglass_stress<W>(g, p, material.youngs_modulus, material.poissons_ratio, Q);
      if constexpr (with_energy)
        energy.stabilisation += hourglass_energy;

      // derivative of the stabilisation energy: by q gives G, by F adds to P
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
      apply_forces<W>(g, nodes, P, G, force);
    }

    template <int W, bool with_energy>
    void
    all_batches(ElementBlocks       &blocks,
                const double        *displacement,
                double              *force,
                const BulkViscosity &viscosity,
                ElementEnergy       &energy)
    {
      const std::size_t n_batches = blocks.n_batches();
      LaneEnergy<W>     sum;
      for (std::size_t batch = 0; batch < n_batches; ++batch)
        batch_force<W, with_energy>(blocks, batch, displacement, force, viscosity, sum);
      energy.strain += stdx::reduce(sum.strain);
      energy.stabilisation += stdx::reduce(sum.stabilisation);
      energy.viscous_power += stdx::reduce(sum.viscous_power);
    }

    template <bool with_energy>
    void
    choose_width(ElementBlocks       &blocks,
                 const double        *displacement,
                 double              *force,
                 const BulkViscosity &viscosity,
                 ElementEnergy       &energy)
    {
      switch (blocks.width)
        {
          case 1:
            return all_batches<1, with_energy>(blocks, displacement, force, viscosity, energy);
          case 2:
            return all_batches<2, with_energy>(blocks, displacement, force, viscosity, energy);
          case 4:
            return all_batches<4, with_energy>(blocks, displacement, force, viscosity, energy);
          default:
            return all_batches<8, with_energy>(blocks, displacement, force, viscosity, energy);
        }
    }
  } // namespace


  void
  subtract_internal_force(ElementBlocks       &blocks,
                          const double        *displacement,
                          double              *force,
                          const BulkViscosity &viscosity,
                          const bool           with_energy,
                          ElementEnergy       &energy)
  {
    if (with_energy)
      choose_width<true>(blocks, displacement, force, viscosity, energy);
    else
      choose_width<false>(blocks, displacement, force, viscosity, energy);
  }


  std::vector<std::array<double, 6>>
  element_stress(const ElementBlocks &blocks, const double *displacement)
  {
    std::vector<std::array<double, 6>> result(blocks.n_elements);
    const int                          W = blocks.width;
    for (std::size_t e = 0; e < blocks.n_elements; ++e)
      {
        const std::size_t batch = e / W, lane = e % W;
        const double     *B = blocks.data.data() + batch * ElementBlocks::fields * W + lane;
        V3<1>             H[3], F[3];
        for (int i = 0; i < 3; ++i)
          for (int j = 0; j < 3; ++j)
            {
              double h = 0;
              for (int a = 0; a < 8; ++a)
                h += displacement[4 * blocks.nodes[(batch * 8 + a) * W + lane] + i] * B[(3 * a + j) * W];
              H[i][j] = h;
              F[i][j] = i == j ? h + 1 : h;
            }
        Simd<1> E[6], S[6];
        stress<1>(H, blocks.material.lame_lambda(), blocks.material.shear_modulus(), E, S);
        // sigma = F S F^T / J
        const double s[3][3] = {
          {S[0][0], S[5][0], S[4][0]}, {S[5][0], S[1][0], S[3][0]}, {S[4][0], S[3][0], S[2][0]}};
        const double f[3][3] = {{F[0][0][0], F[0][1][0], F[0][2][0]},
                                {F[1][0][0], F[1][1][0], F[1][2][0]},
                                {F[2][0][0], F[2][1][0], F[2][2][0]}};
        const double J       = f[0][0] * (f[1][1] * f[2][2] - f[1][2] * f[2][1]) -
                         f[0][1] * (f[1][0] * f[2][2] - f[1][2] * f[2][0]) +
                         f[0][2] * (f[1][0] * f[2][1] - f[1][1] * f[2][0]);
        constexpr int row[6] = {0, 1, 2, 1, 0, 0}, column[6] = {0, 1, 2, 2, 2, 1};
        for (int k = 0; k < 6; ++k)
          {
            double value = 0;
            for (int i = 0; i < 3; ++i)
              for (int j = 0; j < 3; ++j)
                value += f[row[k]][i] * s[i][j] * f[column[k]][j];
            result[e][k] = value / J;
          }
      }
    return result;
  }
} // namespace wheelrail
