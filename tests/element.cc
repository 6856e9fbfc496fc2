// label: fast

// The reduced hexahedron: patch test, rigid motion, exact gradient of its energy, widths, linearisation.

#include "explicit_brick.h"
#include "near.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <string>

using namespace wheelrail;
using test::largest;
using test::Mesh;
using test::nodal;
using test::Vector;

namespace
{
  /// A unit cube of n^3 cells with its inner vertices moved at random.
  Mesh
  distorted_block(const int n, const double amount)
  {
    return test::brick({n, n, n}, {1, 1, 1}, amount);
  }

  AlignedVector<double>
  internal_force(const Mesh &block, const AlignedVector<double> &u, const int width, ElementEnergy &energy)
  {
    ElementBlocks         blocks = pack_elements(block.geometry, block.cells, Elasticity(), width);
    AlignedVector<double> f(u.size(), 0.);
    subtract_internal_force(blocks, u.data(), f.data(), BulkViscosity(), true, energy);
    for (double &x : f)
      x = -x;
    return f;
  }

  BOOST_AUTO_TEST_CASE(patch_test)
  {
    const Mesh    block  = distorted_block(3, 0.25);
    const auto    u      = nodal(block, [](const Vector &X) -> Vector {
      return {1e-3 * X[0] + 2e-3 * X[1], -1e-3 * X[1] + 5e-4 * X[2], 3e-4 * X[0] + 1e-3 * X[2]};
    });
    ElementBlocks blocks = pack_elements(block.geometry, block.cells, Elasticity());
    const auto    stress = element_stress(blocks, u.data());
    double        spread = 0;
    for (const auto &s : stress)
      for (int k = 0; k < 6; ++k)
        spread = std::max(spread, std::abs(s[k] - stress[0][k]));
    BOOST_TEST(
      test::near(spread / std::abs(stress[0][0]), 0, 1e-12, "patch test: equal stress in distorted cells"));
    ElementEnergy energy;
    const auto    f     = internal_force(block, u, native_width, energy);
    double        inner = 0;
    for (unsigned int k = 1; k < 3; ++k)
      for (unsigned int j = 1; j < 3; ++j)
        for (unsigned int i = 1; i < 3; ++i)
          for (int c = 0; c < 3; ++c)
            inner = std::max(inner, std::abs(f[4 * (i + 4 * (j + 4 * k)) + c]));
    BOOST_TEST(test::near(inner / largest(f), 0, 1e-12, "patch test: inner forces vanish"));
    BOOST_TEST(
      test::near(energy.stabilisation / energy.strain, 0, 1e-20, "patch test: no stabilisation energy"));
  }

  BOOST_AUTO_TEST_CASE(rigid_rotation)
  {
    const Mesh    block  = distorted_block(3, 0.25);
    const double  angle  = 10 * 2 * M_PI + 1;
    const auto    u      = nodal(block, [angle](const Vector &X) -> Vector {
      return {5,
              std::cos(angle) * X[1] - std::sin(angle) * X[2] - X[1],
              std::sin(angle) * X[1] + std::cos(angle) * X[2] - X[2]};
    });
    ElementBlocks blocks = pack_elements(block.geometry, block.cells, Elasticity());
    double        worst  = 0;
    for (const auto &s : element_stress(blocks, u.data()))
      for (const double x : s)
        worst = std::max(worst, std::abs(x));
    BOOST_TEST(test::near(worst / 210e9, 0, 1e-13, "ten turns: stress over Young's modulus"));
    ElementEnergy energy;
    BOOST_TEST(test::near(
      largest(internal_force(block, u, native_width, energy)) / 210e9, 0, 1e-13, "ten turns: force"));
  }

  BOOST_AUTO_TEST_CASE(energy_gradient)
  {
    const Mesh                             block = distorted_block(2, 0.25);
    std::mt19937                           random(3);
    std::uniform_real_distribution<double> value(-0.02, 0.02);
    const auto                             rotated = nodal(block, [&](const Vector &X) -> Vector {
      // a large rotation with a rough deformation on top
      const Vector Y = {X[0] + value(random), X[1] + value(random), X[2] + value(random)};
      const double c = std::cos(2.), s = std::sin(2.);
      return {c * Y[0] - s * Y[1] - X[0], s * Y[0] + c * Y[1] - X[1], Y[2] - X[2]};
    });
    ElementEnergy                          ignored;
    const auto                             f     = internal_force(block, rotated, native_width, ignored);
    double                                 worst = 0;
    for (std::size_t n = 0; n < block.vertices.size(); n += 4)
      for (int i = 0; i < 3; ++i)
        {
          const double h = 1e-5;
          double       W[2];
          for (int side = 0; side < 2; ++side)
            {
              auto u = rotated;
              u[4 * n + i] += side == 0 ? -h : h;
              ElementEnergy energy;
              internal_force(block, u, native_width, energy);
              W[side] = energy.strain + energy.stabilisation;
            }
          worst = std::max(worst, std::abs((W[1] - W[0]) / (2 * h) - f[4 * n + i]));
        }
    BOOST_TEST(test::near(worst / largest(f), 0, 1e-7, "force is the exact gradient of the energy"));

    double force[3] = {}, moment[3] = {};
    for (std::size_t n = 0; n < block.vertices.size(); ++n)
      {
        double x[3];
        for (int i = 0; i < 3; ++i)
          {
            x[i] = block.vertices[n][i] + rotated[4 * n + i];
            force[i] += f[4 * n + i];
          }
        for (int i = 0; i < 3; ++i)
          moment[i] += x[(i + 1) % 3] * f[4 * n + (i + 2) % 3] - x[(i + 2) % 3] * f[4 * n + (i + 1) % 3];
      }
    for (int i = 0; i < 3; ++i)
      {
        BOOST_TEST(test::near(force[i] / largest(f), 0, 1e-12, "internal forces sum to zero"));
        BOOST_TEST(test::near(moment[i] / largest(f), 0, 1e-12, "internal moments sum to zero"));
      }
  }

  BOOST_AUTO_TEST_CASE(widths_and_linearisation)
  {
    const Mesh                             block = distorted_block(3, 0.2);
    std::mt19937                           random(5);
    std::uniform_real_distribution<double> value(-1, 1);
    const auto                             u = nodal(block, [&](const Vector &) -> Vector {
      return {value(random) * 1e-9, value(random) * 1e-9, value(random) * 1e-9};
    });
    ElementEnergy                          energy;
    const auto                             f1 = internal_force(block, u, 1, energy);
    for (const int width : {2, 4, 8})
      {
        auto f = internal_force(block, u, width, energy);
        for (std::size_t k = 0; k < f.size(); ++k)
          f[k] -= f1[k];
        BOOST_TEST(test::near(
          largest(f) / largest(f1), 0, 1e-12, "width " + std::to_string(width) + " equals width 1"));
      }
    AlignedVector<double> linear(u.size(), 0.);
    for (std::size_t e = 0; e < block.cells.size(); ++e)
      {
        const auto K = element_stiffness(block.geometry[e], Elasticity());
        for (int r = 0; r < 24; ++r)
          for (int c = 0; c < 24; ++c)
            linear[4 * block.cells[e][r / 3] + r % 3] += K[24 * r + c] * u[4 * block.cells[e][c / 3] + c % 3];
      }
    for (std::size_t k = 0; k < linear.size(); ++k)
      linear[k] -= f1[k];
    BOOST_TEST(
      test::near(largest(linear) / largest(f1), 0, 1e-7, "stiffness matrix is the linearised kernel"));
  }

  /// One layer of brick cells bent in its plane: exact for any aspect ratio with assumed strains.
  BOOST_AUTO_TEST_CASE(pure_bending)
  {
    for (const double nu : {0., 0.3, 0.49})
      {
        Elasticity material;
        material.poissons_ratio    = nu;
        const Vector          size = {4e-3, 1e-3, 2e-3};
        std::array<Vector, 8> X;
        for (int a = 0; a < 8; ++a)
          X[a] = {(a & 1) * size[0], ((a >> 1 & 1) - 0.5) * size[1], ((a >> 2) - 0.5) * size[2]};
        const auto K = element_stiffness(element_geometry(X), material);
        // u_x = kappa x y - ..., u_z anticlastic: with the strains of a beam (plane stress both ways)
        const double kappa = 1e-3;
        double       u[24];
        for (int a = 0; a < 8; ++a)
          {
            const double x = X[a][0] - size[0] / 2, y = X[a][1], z = X[a][2];
            u[3 * a]     = kappa * x * y;
            u[3 * a + 1] = 0;
            u[3 * a + 2] = -nu * kappa * z * y;
          }
        double W = 0;
        for (int r = 0; r < 24; ++r)
          for (int c = 0; c < 24; ++c)
            W += 0.5 * u[r] * K[24 * r + c] * u[c];
        const double I     = size[2] * std::pow(size[1], 3) / 12;
        const double exact = 0.5 * material.youngs_modulus * I * kappa * kappa * size[0];
        BOOST_TEST(
          test::near(W / exact, 1, 1e-12, "bending energy of one flat cell, nu = " + std::to_string(nu)));
      }
  }
} // namespace
