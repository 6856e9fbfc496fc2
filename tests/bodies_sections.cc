// label: fast

// Elastic bodies by 2.5-D elements: a large block against the half-space of Boussinesq and Cerruti, a layer
// on a rigid base in closed form, a wheel of very large radius against a prismatic body, a turning ring.

#include "near.h"

#include <wheelrail/bodies/line_loads.h>
#include <wheelrail/bodies/wave_stiffness.h>
#include <wheelrail/mesh/section_builder.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

using namespace wheelrail;
using test::near;
using test::near_relative;

namespace
{
  const Elasticity steel;

  /// A rectangle of blocks with its running surface at the top, y = `top`.
  Section
  rectangle(const double width, const double depth, const double block, const double top, const Boundary held)
  {
    const unsigned int across = std::lround(width / block), down = std::lround(depth / block);
    SectionBuilder     builder;
    const unsigned int corner[4] = {builder.corner({-0.5 * width, top - depth}),
                                    builder.corner({0.5 * width, top - depth}),
                                    builder.corner({-0.5 * width, top}),
                                    builder.corner({0.5 * width, top})};
    const Side         bottom    = builder.straight(corner[0], corner[1], across),
               upper             = builder.straight(corner[2], corner[3], across);
    builder.patch("block",
                  bottom,
                  upper,
                  builder.straight(corner[0], corner[2], down),
                  builder.straight(corner[1], corner[3], down));
    builder.mark(upper, Boundary::running);
    builder.mark(bottom, held);
    return builder.section();
  }

  double
  entry(const std::vector<double> &C,
        const std::size_t          rows,
        const int                  i,
        const int                  a,
        const int                  j,
        const int                  b)
  {
    return C[3 * rows * (3 * i + a) + 3 * j + b];
  }

  /// Mean of a half-space's response over two rows by many points.
  LineResponse
  mean_line(const SurfaceRow &i, const SurfaceRow &j, const double k, const bool outwards)
  {
    constexpr int n = 32;
    LineResponse  mean{};
    for (int a = 0; a < n; ++a)
      for (int b = 0; b < n; ++b)
        {
          const double s =
            i.place.x + ((a + 0.5) / n - 0.5) * i.width - j.place.x - ((b + 0.5) / n - 0.5) * j.width;
          const LineResponse one =
            halfspace_line(steel.shear_modulus(), steel.poissons_ratio, outwards, k, s);
          for (int c = 0; c < 9; ++c)
            mean[c] += one[c] / (n * n);
        }
    return mean;
  }

  /// Lags of two rows and more of a block: largest difference to the half-space over the self-influence of a
  /// row at that k.
  void
  test_lags(const SectionMesh &mesh, const unsigned int cells, const double k, const double limit)
  {
    WaveStiffness                 stiffness(mesh, steel, false);
    const std::vector<SurfaceRow> all = surface_rows(mesh, cells, false);
    const std::vector<SurfaceRow> rows(all.begin() + all.size() / 2 - 5, all.begin() + all.size() / 2 + 6);
    const std::vector<double>     C     = stiffness.compliance(k, rows);
    const double                  self  = entry(C, rows.size(), 5, 1, 5, 1);
    double                        worst = 0;
    for (int i = 0; i < 11; ++i)
      if (std::abs(i - 5) >= 2)
        {
          const LineResponse H = mean_line(rows[i], rows[5], k, true);
          for (int a = 0; a < 3; ++a)
            for (int b = 0; b < 3; ++b)
              worst = std::max(worst, std::abs(entry(C, rows.size(), i, a, 5, b) - H[3 * a + b]));
        }
    BOOST_TEST(worst < limit * self,
               "block, " + std::to_string(cells) + " cells a row, k = " + std::to_string(k) +
                 ": largest difference over self influence " + std::to_string(worst / self));
  }

  /// Cells that grow below the surface, as those of tables, with one and two of them a row; even cells, four
  /// a row, on a block that is large for short waves alone.
  BOOST_AUTO_TEST_CASE(test_block)
  {
    const auto block =
      [](const double width, const double depth, const double cell, const unsigned int levels) {
        return mesh_section(rectangle(width, depth, cell, 0, Boundary::foot), Boundary::foot, levels);
      };
    for (const double k : {100., 300., 1000.})
      {
        test_lags(block(0.3, 0.1, 0.0125, 2), 1, k, 8e-3);
        test_lags(block(0.3, 0.1, 0.0125, 3), 2, k, 1e-3);
      }
    for (const double k : {300., 1000.})
      test_lags(block(0.1, 0.05, 0.00078125, 0), 4, k, 1e-4);
  }

  /// An elastic layer that is held on a rigid base, long along the line, under a pressure over its surface
  /// that is even or Hertz's on |x| < a: displacement as Fourier's integral
  ///   u(x) = 2 (1 - nu^2)/(pi E) int L(q b)/q p(q) cos(q x) dq,
  ///   L(t) = (2 kappa sinh 2t - 4t)/(2 kappa cosh 2t + 4 t^2 + 1 + kappa^2), kappa = 3 - 4 nu
  /// (Airy's function with both displacements zero at the depth b; Meijers 1968), in the mean over each row.
  BOOST_AUTO_TEST_CASE(test_layer)
  {
    constexpr double  width = 0.3, depth = 0.0125, a = 0.0125;
    const SectionMesh mesh =
      mesh_section(rectangle(width, depth, depth, 0, Boundary::foot), Boundary::foot, 4);
    WaveStiffness                 stiffness(mesh, steel, false);
    const std::vector<SurfaceRow> all    = surface_rows(mesh, 1, false);
    const int                     middle = static_cast<int>(all.size()) / 2, reach = 20;
    const std::vector<SurfaceRow> rows(all.begin() + middle - reach, all.begin() + middle + reach);
    const std::vector<double>     C  = stiffness.compliance(1e-3, rows);
    const double                  nu = steel.poissons_ratio, kappa = 3 - 4 * nu, row = rows[0].width;
    for (const bool hertz : {false, true})
      {
        const auto layer = [&](const double x) {
          constexpr double step = 0.25, last = 2e4;
          double           sum = 0;
          for (double q = 0.5 * step; q < last; q += step)
            {
              const double t = q * depth, e = std::exp(-2 * t), e2 = e * e;
              const double L =
                (kappa * (1 - e2) - 4 * t * e) / (kappa * (1 + e2) + (4 * t * t + 1 + kappa * kappa) * e);
              const double p    = hertz ? M_PI * std::cyl_bessel_j(1, q * a) / q : 2 * std::sin(q * a) / q;
              const double mean = std::sin(0.5 * q * row) / (0.5 * q * row);
              sum += L / q * p * mean * std::cos(q * x) * step;
            }
          return 2 * (1 - nu * nu) / (M_PI * steel.youngs_modulus) * sum;
        };
        double worst = 0, largest = 0;
        for (std::size_t i = 0; i < rows.size(); ++i)
          {
            double u = 0;
            for (std::size_t j = 0; j < rows.size(); ++j)
              if (const double x = std::abs(rows[j].place.x); x < a)
                {
                  // mean of Hertz's pressure over the row
                  const auto area = [](const double s) {
                    return 0.5 * (s * std::sqrt(std::max(0., 1 - s * s)) + std::asin(std::min(1., s)));
                  };
                  const double p =
                    hertz ? a / row * (area((x + 0.5 * row) / a) - area((x - 0.5 * row) / a)) : 1;
                  u += row * p * entry(C, rows.size(), int(i), 1, int(j), 1);
                }
            const double expected = layer(rows[i].place.x);
            worst                 = std::max(worst, std::abs(u - expected));
            largest               = std::max(largest, expected);
          }
        BOOST_TEST(worst < 5e-3 * largest,
                   std::string("layer on a rigid base under ") + (hertz ? "Hertz's" : "even") +
                     " pressure: largest difference over the largest displacement " +
                     std::to_string(worst / largest));
      }
  }

  /// A wheel of 10 km radius is a prismatic body: k = n / r.
  BOOST_AUTO_TEST_CASE(test_large_wheel)
  {
    const double  radius = 1e4, k = 40;
    const Section flat           = rectangle(0.2, 0.1, 0.02, 0, Boundary::foot),
                  round          = rectangle(0.2, 0.1, 0.02, radius, Boundary::bore);
    const SectionMesh flat_mesh  = mesh_section(flat, Boundary::foot, 2),
                      round_mesh = mesh_section(round, Boundary::bore, 2);
    WaveStiffness rail(flat_mesh, steel, false), wheel(round_mesh, steel, true);
    const auto rail_rows = surface_rows(flat_mesh, 1, false), wheel_rows = surface_rows(round_mesh, 1, true);
    const auto C = rail.compliance(k, rail_rows), W = wheel.compliance(k * radius, wheel_rows);
    double     worst     = 0;
    const double largest = *std::max_element(C.begin(), C.end());
    for (std::size_t e = 0; e < C.size(); ++e)
      worst = std::max(worst, std::abs(C[e] - W[e]));
    BOOST_TEST(worst < 1e-4 * largest, "a very large wheel is prismatic: " + std::to_string(worst / largest));
  }

  /// A thin disc that turns, clamped at its bore: plane stress in closed form (Timoshenko and Goodier 1970,
  /// article 32).
  BOOST_AUTO_TEST_CASE(test_growth)
  {
    const double inner = 0.1, outer = 0.46, width = 0.004, rate = 100;
    // u = A r + B / r - (1 - nu^2) rho w^2 r^3 / (8 E), u(inner) = 0, sigma_r(outer) = 0
    const double nu = steel.poissons_ratio,
                 f  = (1 - nu * nu) * steel.density * rate * rate / (8 * steel.youngs_modulus);
    // sigma_r ~ (1 + nu) A - (1 - nu) B / r^2 - (3 + nu) f r^2
    const double a11 = inner, a12 = 1 / inner, b1 = f * std::pow(inner, 3);
    const double a21 = 1 + nu, a22 = -(1 - nu) / (outer * outer), b2 = (3 + nu) * f * outer * outer;
    const double det = a11 * a22 - a12 * a21, A = (b1 * a22 - a12 * b2) / det,
                 B     = (a11 * b2 - a21 * b1) / det;
    const double exact = A * outer + B / outer - f * std::pow(outer, 3);

    const unsigned int down = 90;
    SectionBuilder     builder;
    const unsigned int corner[4] = {builder.corner({-0.5 * width, inner}),
                                    builder.corner({0.5 * width, inner}),
                                    builder.corner({-0.5 * width, outer}),
                                    builder.corner({0.5 * width, outer})};
    const Side         bottom    = builder.straight(corner[0], corner[1], 1),
               upper             = builder.straight(corner[2], corner[3], 1);
    builder.patch("ring",
                  bottom,
                  upper,
                  builder.straight(corner[0], corner[2], down),
                  builder.straight(corner[1], corner[3], down));
    builder.mark(upper, Boundary::running);
    builder.mark(bottom, Boundary::bore);
    const SectionMesh mesh = mesh_section(builder.section(), Boundary::bore, 0);
    WaveStiffness     ring(mesh, steel, true);
    const auto        growth = ring.growth(rate, steel.density, surface_rows(mesh, 1, true));
    BOOST_TEST(near_relative(growth.front().y, exact, 2e-3, "growth of a turning disc, plane stress"));
    BOOST_TEST(near(growth.front().x, 0, 1e-8 * exact, "it grows straight outwards"));
  }
} // namespace
