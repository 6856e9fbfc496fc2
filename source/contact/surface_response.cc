#include <deal.II/lac/full_matrix.h>

#include <wheelrail/contact/surface_response.h>

#include <cmath>
#include <complex>

// Discrete compliance of a half-space of unit cubes under nodal forces exp(i k x), over the exact one
// (doc/theory/contact.md, Surface filter): layers of elements put on one another until the ground below has
// no effect. Its excess over (k h)^2 is the weight of the filter; nothing is fitted.

namespace wheelrail
{
  namespace
  {
    using Matrix = dealii::FullMatrix<std::complex<double>>;

    /// Stiffness of one layer of cubes in its lower and upper unknowns (3 each) when all nodes move
    /// with exp(i k x).
    Matrix
    layer_stiffness(const std::array<double, 24 * 24> &stiffness, const double kx, const double ky)
    {
      Matrix layer(6, 6);
      for (int a = 0; a < 8; ++a)
        for (int b = 0; b < 8; ++b)
          {
            // Bloch's theorem: node b of a cube moves as node a of its neighbour times exp(i phase), so that
            // one layer has 3 unknowns below and 3 above
            const double phase = kx * ((b & 1) - (a & 1)) + ky * ((b >> 1 & 1) - (a >> 1 & 1));
            for (int i = 0; i < 3; ++i)
              for (int j = 0; j < 3; ++j)
                layer(3 * (a >> 2) + i, 3 * (b >> 2) + j) +=
                  stiffness[24 * (3 * a + i) + 3 * b + j] * std::polar(1., phase);
          }
      return layer;
    }

    Matrix
    block(const Matrix &whole, const int row, const int column)
    {
      Matrix part(3, 3);
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
          part(i, j) = whole(3 * row + i, 3 * column + j);
      return part;
    }

    /// Displacements of the surface under unit forces: layers are put on top of each other until the
    /// fixed ground below has no effect.
    Matrix
    surface_compliance(const Matrix &layer, const double k)
    {
      const Matrix lower = block(layer, 0, 0), coupling = block(layer, 0, 1), back = block(layer, 1, 0),
                   upper = block(layer, 1, 1);
      // start: one layer on a rigid ground, T = K_uu
      Matrix top = upper;
      // a wave dies as exp(-k z): after 20/k layers 1e-9 of it is left
      const int n_layers = 10 + static_cast<int>(std::ceil(20 / k));
      for (int n = 0; n < n_layers; ++n)
        {
          // stiffness of a ground with one more layer: T' = K_uu - K_ul (K_ll + T)^-1 K_lu (Schur complement)
          Matrix below = lower, step(3, 3), loss(3, 3);
          below.add(1., top);
          below.gauss_jordan();
          below.mmult(step, coupling);
          back.mmult(loss, step);
          top = upper;
          top.add(-1., loss);
        }
      top.gauss_jordan();
      return top;
    }
  } // namespace


  SurfaceResponse
  surface_response(const std::array<double, 24 * 24> &stiffness,
                   const Elasticity                  &material,
                   const double                       kx,
                   const double                       ky)
  {
    // wave number times the edge of a cube of 1 m; how normal and tangential are coupled is left out
    const double k  = std::hypot(kx, ky);
    const Matrix c  = surface_compliance(layer_stiffness(stiffness, kx, ky), k);
    const double nu = material.poissons_ratio, cx = kx / k, cy = ky / k;
    // (1 - nu)/(G k) under pressure and under traction along the wave, 1/(G k) under traction across it
    const double exact        = 2 * (1 - nu * nu) / (material.youngs_modulus * k);
    const double exact_across = 2 * (1 + nu) / (material.youngs_modulus * k);
    const double xx = c(0, 0).real(), yy = c(1, 1).real(), xy = c(0, 1).real(), yx = c(1, 0).real();
    // (c_x, c_y) C (c_x, c_y)' along the wave, (-c_y, c_x) across it
    const double parallel      = cx * cx * xx + cx * cy * (xy + yx) + cy * cy * yy;
    const double perpendicular = cy * cy * xx - cx * cy * (xy + yx) + cx * cx * yy;
    return {c(2, 2).real() / exact - 1, parallel / exact - 1, perpendicular / exact_across - 1};
  }


  SurfaceFilter
  surface_filter(const std::array<double, 24 * 24> &stiffness, const Elasticity &material)
  {
    // small enough for the next order to stay below one per cent of the error
    // k h = 0.3, along the cells and at 45 degrees to them
    const double k = 0.3, half = k / std::sqrt(2.);
    // the response of a lattice is not the same in all directions: the mean of both serves for normal loads
    const auto    straight = surface_response(stiffness, material, k, 0);
    const auto    oblique  = surface_response(stiffness, material, half, half);
    SurfaceFilter filter;
    // excess over (k h)^2 with h = 1
    filter.normal = 0.5 * (straight.normal + oblique.normal) / (k * k);
    // w = 0.083 for nu = 0.3: the part that is geometry, 1/12, since a nodal force is the mean of the
    // traction over a hat function
    filter.shear = straight.perpendicular / (k * k);
    return filter;
  }
} // namespace wheelrail
