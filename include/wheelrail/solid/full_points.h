#pragma once

#include <wheelrail/base/simd.h>

#include <cmath>

namespace wheelrail
{
  /// The `full` hexahedron at its eight Gauss points, W elements at once; see doc/theory/element.md.
  ///
  /// Points and nodes are numbered alike: bit k of the number is set when the coordinate xi_k is
  /// positive. A derivative along xi_k does not vary with xi_k, so that it has four values for the
  /// eight points: value v belongs to the points whose other two coordinates have the bits of v.
  namespace full
  {
    constexpr double gauss = 0.57735026918962576; ///< 1/sqrt(3)

    /// Rows of the packed geometry, each of W numbers: the coefficients of the trilinear map
    /// X = sum c f(xi) for f = xi_k (3 x 3), for the products of two coordinates that lack xi_k
    /// (3 x 3, times 1/sqrt(3)) and for the product of all (3, times 1/3) [m], so that derivatives at
    /// the points are their sums and differences; then the length of the bulk viscosity [m].
    constexpr int linear_row = 0, product_row = 9, triple_row = 18, length_row = 21, fields = 22;

    /// The two directions other than k, and the value of a derivative along k at point g.
    constexpr int
    low(const int k)
    {
      return k == 0 ? 1 : 0;
    }
    constexpr int
    high(const int k)
    {
      return k == 2 ? 1 : 2;
    }
    constexpr int
    value_of_point(const int k, const int g)
    {
      return (g >> low(k) & 1) + 2 * (g >> high(k) & 1);
    }
    /// Node at the lower end of the edge along k with the bits v.
    constexpr int
    edge_begin(const int k, const int v)
    {
      return ((v & 1) << low(k)) + ((v >> 1) << high(k));
    }

    /// Derivatives of a vector along the natural coordinates: [direction][value][component].
    template <int W>
    using Derivatives = Simd<W>[3][4][3];

    /// dX/dxi at the points.
    template <int W>
    inline void
    reference_derivatives(const double *data, Derivatives<W> &D)
    {
      const auto row = [data](const int r) {
        return Simd<W>(data + r * W, std::experimental::vector_aligned);
      };
      for (int k = 0; k < 3; ++k)
        for (int i = 0; i < 3; ++i)
          {
            // the product of xi_k and xi_low lacks xi_high
            const Simd<W> c = row(linear_row + 3 * k + i), l = row(product_row + 3 * high(k) + i),
                          h = row(product_row + 3 * low(k) + i), t = row(triple_row + i);
            const Simd<W> m = c - h, p = c + h, a = l - t, b = l + t;
            D[k][0][i] = m - a;
            D[k][1][i] = m + a;
            D[k][2][i] = p - b;
            D[k][3][i] = p + b;
          }
    }

    /// du/dxi at the points from the nodal values: differences along the edges, interpolated.
    template <int W>
    inline void
    nodal_derivatives(const Simd<W> (&u)[8][3], Derivatives<W> &D)
    {
      constexpr double near = (1 + gauss) / 2, far = (1 - gauss) / 2;
      for (int k = 0; k < 3; ++k)
        for (int i = 0; i < 3; ++i)
          {
            Simd<W> e[4];
            for (int v = 0; v < 4; ++v)
              e[v] = u[edge_begin(k, v) + (1 << k)][i] - u[edge_begin(k, v)][i];
            const Simd<W> a = near / 2 * e[0] + far / 2 * e[1], b = far / 2 * e[0] + near / 2 * e[1],
                          c = near / 2 * e[2] + far / 2 * e[3], d = far / 2 * e[2] + near / 2 * e[3];
            D[k][0][i] = near * a + far * c;
            D[k][1][i] = near * b + far * d;
            D[k][2][i] = far * a + near * c;
            D[k][3][i] = far * b + near * d;
          }
    }

    /// The transpose of nodal_derivatives: nodal forces of the stresses N that work on the derivatives.
    template <int W>
    inline void
    nodal_forces(const Derivatives<W> &N, Simd<W> (&f)[8][3])
    {
      constexpr double near = (1 + gauss) / 2, far = (1 - gauss) / 2;
      for (int k = 0; k < 3; ++k)
        for (int i = 0; i < 3; ++i)
          {
            const Simd<W> a = near * N[k][0][i] + far * N[k][2][i], b = near * N[k][1][i] + far * N[k][3][i],
                          c = far * N[k][0][i] + near * N[k][2][i], d = far * N[k][1][i] + near * N[k][3][i];
            const Simd<W> e[4] = {near / 2 * a + far / 2 * b,
                                  far / 2 * a + near / 2 * b,
                                  near / 2 * c + far / 2 * d,
                                  far / 2 * c + near / 2 * d};
            for (int v = 0; v < 4; ++v)
              {
                const int begin = edge_begin(k, v), end = begin + (1 << k);
                f[begin][i] = k == 0 ? -e[v] : f[begin][i] - e[v];
                f[end][i]   = k == 0 ? e[v] : f[end][i] + e[v];
              }
          }
    }

    /// One Gauss point.
    template <int W>
    struct Point
    {
      Simd<W> F[3][3];        ///< deformation gradient
      Simd<W> cofactor[3][3]; ///< [k][j] = det(dX/dxi) dxi_k/dX_j
      Simd<W> weight;         ///< det(dX/dxi): its share of the volume [m3]
      Simd<W> E[6];           ///< Green's strain, xx yy zz yz xz xy
    };

    /// Point g from the derivatives of the reference coordinates and of the displacement.
    template <int W>
    inline void
    evaluate_point(const Derivatives<W> &dX, const Derivatives<W> &du, const int g, Point<W> &point)
    {
      Simd<W> J[3][3], U[3][3], H[3][3]; // J, U: [direction][component]
      for (int k = 0; k < 3; ++k)
        for (int i = 0; i < 3; ++i)
          {
            J[k][i] = dX[k][value_of_point(k, g)][i];
            U[k][i] = du[k][value_of_point(k, g)][i];
          }
      for (int k = 0; k < 3; ++k)
        for (int j = 0; j < 3; ++j)
          {
            const int k1 = (k + 1) % 3, k2 = (k + 2) % 3, j1 = (j + 1) % 3, j2 = (j + 2) % 3;
            point.cofactor[k][j] = J[k1][j1] * J[k2][j2] - J[k1][j2] * J[k2][j1];
          }
      const auto &C        = point.cofactor;
      point.weight         = J[0][0] * C[0][0] + J[0][1] * C[0][1] + J[0][2] * C[0][2];
      const Simd<W> factor = 1. / point.weight;
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
          {
            H[i][j]       = factor * (U[0][i] * C[0][j] + U[1][i] * C[1][j] + U[2][i] * C[2][j]);
            point.F[i][j] = i == j ? H[i][j] + 1. : H[i][j];
          }
      // from H and not from F: no digits are lost when strains are small
      constexpr int row[6] = {0, 1, 2, 1, 0, 0}, column[6] = {0, 1, 2, 2, 2, 1};
      for (int k = 0; k < 6; ++k)
        {
          const int i = row[k], j = column[k];
          point.E[k] = 0.5 * (H[i][j] + H[j][i] + H[0][i] * H[0][j] + H[1][i] * H[1][j] + H[2][i] * H[2][j]);
        }
    }

    template <int W>
    inline Simd<W>
    trace(const Simd<W> (&E)[6])
    {
      return E[0] + E[1] + E[2];
    }

    /// Replaces the dilatational part of a strain.
    template <int W>
    inline void
    set_trace(const Simd<W> &dilatation, Simd<W> (&E)[6])
    {
      const Simd<W> missing = (1. / 3) * (dilatation - trace<W>(E));
      for (int k = 0; k < 3; ++k)
        E[k] += missing;
    }

    /// Adds the part of point g with the second Piola-Kirchhoff stress S to N.
    template <int W>
    inline void
    add_point_stress(const Point<W> &point, const Simd<W> (&S)[6], const int g, Derivatives<W> &N)
    {
      for (int i = 0; i < 3; ++i)
        {
          const auto   &F    = point.F[i];
          const Simd<W> P[3] = {F[0] * S[0] + F[1] * S[5] + F[2] * S[4],
                                F[0] * S[5] + F[1] * S[1] + F[2] * S[3],
                                F[0] * S[4] + F[1] * S[3] + F[2] * S[2]};
          for (int k = 0; k < 3; ++k)
            {
              const auto &C = point.cofactor[k];
              N[k][value_of_point(k, g)][i] += P[0] * C[0] + P[1] * C[1] + P[2] * C[2];
            }
        }
    }
  } // namespace full
} // namespace wheelrail
