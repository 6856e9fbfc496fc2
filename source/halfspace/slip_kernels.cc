#include <wheelrail/halfspace/slip_kernels.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

// B of s = w + B t, and the inverse of A for the preconditioner: 2 x 2 symbols of convolutions over the
// doubled grid, pairs xx, xy, yy.

namespace wheelrail
{
  SlipKernels
  slip_kernels(InfluenceProducts        &products,
               const HalfspaceConstants &constants,
               const HalfspaceGrid      &grid,
               const double              step,
               const bool                steady)
  {
    SlipKernels k;
    // xx, xy, yy: A_xy = A_yx, and tractions along n enter by the rigid slip
    k.step                                 = step;
    k.steady                               = steady;
    const std::vector<InfluencePair> pairs = {{0, 0}, {0, 1}, {1, 1}};
    auto                             here  = influence_by_distance(constants, grid, products, 0, pairs);
    InfluenceProducts::Spectrum      xx = products.kernel(here[0]), xy = products.kernel(here[1]),
                                yy = products.kernel(here[2]);
    for (std::vector<double> *inverse : {&k.inverse_xx, &k.inverse_xy, &k.inverse_yy})
      inverse->resize(xx.size());
    // kernel() holds the factor 1 / size that belongs to the inverse transform: it must stand in the inverse,
    // too. (1/N A)^-1 = N A^-1; what is wanted is A^-1/N: the factor 1/N^2
    const double scale = 1. / std::pow(double(products.padded_size()), 2);
    for (std::size_t m = 0; m < xx.size(); ++m)
      {
        // The symbol of A at a wavenumber is (a b; b d), real since A is even in x and y together. Its
        // inverse is (d -b; -b a)/det.
        const double a = std::abs(xx[m].real()), b = xy[m].real(), d = std::abs(yy[m].real());
        // a preconditioner only: kept away from singular where the cut kernels' symbol is not definite
        // of long periodic waves the kernels' cut at the edge of the grid leaves symbols that are not
        // positive
        const double det = std::max(a * d - b * b, 0.01 * a * d);
        k.inverse_xx[m]  = scale * d / det;
        k.inverse_xy[m]  = -scale * b / det;
        k.inverse_yy[m]  = scale * a / det;
      }
    // of an element on itself [m/Pa]
    const auto c0 = influence_coefficients(constants, grid.dx, grid.dy, 0, 0);
    if (steady)
      {
        const auto there = influence_by_distance(constants, grid, products, step, pairs);
        for (std::size_t c = 0; c < pairs.size(); ++c)
          for (std::size_t e = 0; e < here[c].size(); ++e)
            // steady rolling: s = w + (u - u')/dq, B = (A(I) - A(I + dq))/dq, u' where the particle was one
            // step before (Kalker 1990; doc/theory/halfspace.md, Frame and signs)
            here[c][e] = (here[c][e] - there[c][e]) / step;
        k.xx          = products.kernel(here[0]);
        k.xy          = products.kernel(here[1]);
        k.yy          = products.kernel(here[2]);
        const auto c1 = influence_coefficients(constants, grid.dx, grid.dy, step, 0);
        // b of the Newton steps: the slip of an element under its own traction, mean of x and y [1/Pa]
        k.diagonal = (c0[0][0] - c1[0][0] + c0[1][1] - c1[1][1]) / (2 * step);
      }
    else
      {
        // shift and one step of transient rolling: u' is known and stands in the rigid slip, so that B = A/dq
        for (auto *s : {&xx, &xy, &yy})
          for (auto &v : *s)
            v /= step;
        k.xx       = std::move(xx);
        k.xy       = std::move(xy);
        k.yy       = std::move(yy);
        k.diagonal = (c0[0][0] + c0[1][1]) / (2 * step);
      }
    return k;
  }
} // namespace wheelrail
