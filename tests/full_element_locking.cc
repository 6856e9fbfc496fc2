// label: fast

// The full hexahedron of nearly incompressible material against Lame's thick tube, and against plain 2 x 2 x
// 2 integration, which locks.

#include <wheelrail/solid/element_blocks.h>

#include "explicit_brick.h"
#include "near.h"
#include "scenes/shapes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <string>
#include <vector>

using namespace wheelrail;
using namespace test;

namespace
{
  /// Determinant of the Jacobian at a Gauss point.
  double
  jacobian(const std::array<Vector, 8> &X, const int point)
  {
    const double g = 1 / std::sqrt(3.);
    Vector3      J[3]{};
    for (int a = 0; a < 8; ++a)
      for (int k = 0; k < 3; ++k)
        {
          double d = a >> k & 1 ? 0.5 : -0.5;
          for (int l = 0; l < 3; ++l)
            if (l != k)
              d *= (1 + ((a ^ point) >> l & 1 ? -g : g)) / 2;
          add(J[k], d, {X[a][0], X[a][1], X[a][2]});
        }
    return dot(J[0], cross(J[1], J[2]));
  }

  /// Stiffness of plain 2 x 2 x 2 integration, each point with its own dilatation: that of the full
  /// element plus the bulk modulus times the variance of the dilatation.
  std::array<double, 24 * 24>
  plain_stiffness(const std::array<Vector, 8> &X, const Elasticity &material)
  {
    double volume = 0, change[8][24], mean[24] = {}, determinant[8];
    for (int point = 0; point < 8; ++point)
      {
        determinant[point] = jacobian(X, point);
        volume += determinant[point];
        for (int r = 0; r < 24; ++r)
          {
            auto Y = X; // a determinant is linear in each coordinate, so that the step may be large
            Y[r / 3][r % 3] += 1;
            change[point][r] = jacobian(Y, point) - determinant[point];
            mean[r] += change[point][r];
          }
      }
    auto K = element_stiffness(element_geometry(X), material, ElementForm::full);
    for (int r = 0; r < 24; ++r)
      for (int c = 0; c < 24; ++c)
        {
          double extra = -mean[r] * mean[c] / volume;
          for (int point = 0; point < 8; ++point)
            extra += change[point][r] * change[point][c] / determinant[point];
          K[24 * r + c] += material.bulk_modulus() * extra;
        }
    return K;
  }

  /// Solves K u = f with the dofs marked `held` at zero by conjugate gradients with the diagonal.
  std::vector<double>
  solve(const LocalMesh                                &mesh,
        const std::vector<std::array<double, 24 * 24>> &K,
        const std::vector<double>                      &f,
        const std::vector<bool>                        &held)
  {
    const std::size_t   n = f.size();
    std::vector<double> x(n, 0.), r(f), p(n, 0.), z(n), q(n), diagonal(n, 0.);
    for (std::size_t e = 0; e < mesh.cells.size(); ++e)
      for (int k = 0; k < 24; ++k)
        diagonal[3 * mesh.cells[e][k / 3] + k % 3] += K[e][25 * k];
    for (std::size_t k = 0; k < n; ++k)
      if (held[k])
        r[k] = 0;
    double old = 0, start = 0;
    for (int step = 0; step < 20000; ++step)
      {
        double rz = 0;
        for (std::size_t k = 0; k < n; ++k)
          {
            z[k] = r[k] / diagonal[k];
            rz += r[k] * z[k];
          }
        start = step == 0 ? rz : start;
        if (rz < 1e-20 * start)
          break;
        for (std::size_t k = 0; k < n; ++k)
          p[k] = z[k] + (step == 0 ? 0 : rz / old) * p[k];
        std::fill(q.begin(), q.end(), 0.);
        for (std::size_t e = 0; e < mesh.cells.size(); ++e)
          for (int a = 0; a < 24; ++a)
            for (int b = 0; b < 24; ++b)
              q[3 * mesh.cells[e][a / 3] + a % 3] += K[e][24 * a + b] * p[3 * mesh.cells[e][b / 3] + b % 3];
        double pq = 0;
        for (std::size_t k = 0; k < n; ++k)
          {
            q[k] = held[k] ? 0 : q[k];
            pq += p[k] * q[k];
          }
        for (std::size_t k = 0; k < n; ++k)
          {
            x[k] += rz / pq * p[k];
            r[k] -= rz / pq * q[k];
          }
        old = rz;
      }
    return x;
  }

  /// Radial displacement of the bore of a thick tube under inner pressure in plane strain, over Lame's
  /// exact one.
  double
  tube_ratio(const double nu, const bool full)
  {
    Elasticity material;
    material.poissons_ratio = nu;
    const double        a = 1, b = 2, pressure = 1e6;
    const LocalMesh     mesh = scenes::quarter_cylinder(a, b, 0.25, {8, 12, 1});
    std::vector<bool>   held(3 * mesh.n_nodes());
    std::vector<double> load(3 * mesh.n_nodes(), 0.);
    for (unsigned int node = 0; node < mesh.n_nodes(); ++node)
      {
        const Vector3 X    = scenes::place_of(mesh, node);
        held[3 * node]     = X[0] < 1e-9;
        held[3 * node + 1] = X[1] < 1e-9;
        held[3 * node + 2] = true;
      }
    for (const auto &face :
         scenes::select_faces(mesh, [&](const Vector3 &X) { return std::hypot(X[0], X[1]) < a + 1e-9; }))
      {
        const Vector3 corner  = scenes::place_of(mesh, face.nodes[0]);
        const Vector3 outward = cross(scenes::place_of(mesh, face.nodes[1]) - corner,
                                      scenes::place_of(mesh, face.nodes[2]) - corner);
        for (const unsigned int node : face.nodes)
          for (int i = 0; i < 3; ++i)
            load[3 * node + i] -= pressure / 4 * outward[i];
      }
    std::vector<std::array<double, 24 * 24>> K;
    for (const auto &g : cell_geometry(mesh))
      K.push_back(full ? element_stiffness(g, material, ElementForm::full)
                       : plain_stiffness(g.vertices, material));
    const double exact = (1 + nu) / material.youngs_modulus * pressure * a * a / (b * b - a * a) *
                         ((1 - 2 * nu) * a + b * b / a);
    const unsigned int probe =
      scenes::select(mesh, [](const Vector3 &X) { return X[0] < 1 + 1e-9 && X[1] + X[2] < 1e-9; }).at(0);
    return solve(mesh, K, load, held)[3 * probe] / exact;
  }

  BOOST_AUTO_TEST_CASE(no_volumetric_locking)
  {
    for (const double nu : {0.3, 0.49, 0.4999})
      {
        const double full = tube_ratio(nu, true), plain = tube_ratio(nu, false);
        BOOST_TEST(
          near(full, 1, 0.01, "thick tube, nu = " + std::to_string(nu) + ": bore displacement over Lame's"));
        std::cout << "        plain 2 x 2 x 2 integration: " << plain << std::endl;
        if (nu > 0.4998)
          BOOST_TEST(plain < 0.5, "which locks");
      }
  }
} // namespace
