// label: fast

// The full hexahedron: patch test, finite rotation, exact gradient of its energy, SIMD widths, linearisation,
// rigid modes, plastic flow.

#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/lapack_full_matrix.h>

#include <wheelrail/solid/exchange.h>
#include <wheelrail/solid/full_element.h>

#include "explicit_brick.h"
#include "parallel.h"
#include "scenes/dynamics.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>
#include <string>

using namespace wheelrail;
using namespace test;

namespace
{
  /// Nodal values of a field of the reference coordinates, four numbers a node.
  AlignedVector<double>
  nodal_field(const LocalMesh &mesh, const std::function<Vector(const Vector &)> &field)
  {
    AlignedVector<double> values(4 * mesh.n_nodes(), 0.);
    for (std::size_t n = 0; n < mesh.n_nodes(); ++n)
      {
        const double *X     = &mesh.reference[4 * n];
        const Vector  value = field({X[0], X[1], X[2]});
        for (int i = 0; i < 3; ++i)
          values[4 * n + i] = value[i];
      }
    return values;
  }

  /// A unit block of 8 coarse cells, one of them refined, inner vertices moved at random.
  LocalMesh
  distorted_block()
  {
    LocalMesh mesh = scenes::two_level_box(
      {0, 0, 0}, {1, 1, 1}, {2, 2, 2}, [](const Vector3 &X) { return X[0] + X[1] + X[2] < 1; }, 0.2);
    scenes::distort(mesh, 0.1, [](const Vector3 &X) { return X[0] > 0.9; });
    scenes::distort(mesh, 0.05, [](const Vector3 &X) { return norm(X - Vector3{0.25, 0.25, 0.25}) < 0.15; });
    return mesh;
  }

  AlignedVector<double>
  internal_force(const LocalMesh             &mesh,
                 const AlignedVector<double> &u,
                 ElementEnergy               &energy,
                 const int                    width    = native_width,
                 const Elasticity            &material = Elasticity())
  {
    ElementBlocks blocks = pack_elements(cell_geometry(mesh), mesh.cells, material, width, ElementForm::full);
    AlignedVector<double> f(u.size(), 0.);
    subtract_internal_force(blocks, u.data(), f.data(), BulkViscosity(), true, energy);
    for (double &x : f)
      x = -x;
    return f;
  }

  /// Nodes that are neither on the surface of the unit block nor hanging.
  std::vector<unsigned int>
  inner_nodes(const LocalMesh &mesh)
  {
    std::vector<int> cells(mesh.n_nodes(), 0);
    for (const auto &cell : mesh.cells)
      for (const auto node : cell)
        ++cells[node];
    std::vector<unsigned int> inner;
    for (unsigned int n = 0; n < mesh.n_nodes(); ++n)
      if (cells[n] == 8)
        inner.push_back(n);
    return inner;
  }

  void
  patch_test()
  {
    const LocalMesh mesh  = distorted_block();
    const auto      inner = inner_nodes(mesh);
    const auto      u     = nodal_field(mesh, [](const Vector &X) -> Vector {
      return {1e-3 * X[0] + 2e-3 * X[1], -1e-3 * X[1] + 5e-4 * X[2], 3e-4 * X[0] + 1e-3 * X[2]};
    });
    BOOST_TEST((inner.size() == 2 && mesh.hanging.size() == 12),
               "the graded block has 2 inner and 12 hanging nodes");

    const ElementBlocks blocks =
      pack_elements(cell_geometry(mesh), mesh.cells, Elasticity(), native_width, ElementForm::full);
    const auto first  = element_stress(blocks, u.data())[0];
    double     spread = 0;
    for (std::size_t e = 0; e < mesh.cells.size(); ++e)
      for (const auto &s : full_point_stress(blocks, e, u.data()))
        for (int k = 0; k < 6; ++k)
          spread = std::max(spread, std::abs(s[k] - first[k]));
    BOOST_TEST(near(
      spread / std::abs(first[0]), 0, 1e-12, "patch test: equal stress at all points of distorted cells"));

    ElementEnergy energy;
    auto          f = internal_force(mesh, u, energy);
    condense(mesh, f.data());
    double on_inner = 0, sum[3] = {0, 0, 0};
    for (const auto n : inner)
      for (int i = 0; i < 3; ++i)
        on_inner = std::max(on_inner, std::abs(f[4 * n + i]));
    for (std::size_t k = 0; k < f.size(); ++k)
      if (k % 4 < 3)
        sum[k % 4] += f[k];
    BOOST_TEST(
      near(on_inner / largest(f), 0, 1e-12, "patch test: inner forces vanish across the jump of cell size"));
    for (int i = 0; i < 3; ++i)
      BOOST_TEST(near(sum[i] / largest(f), 0, 1e-12, "patch test: surface forces are opposite and equal"));
  }

  /// Stretch and shear, then a rotation by `angle` about an inclined axis, plus a translation.
  AlignedVector<double>
  turned_stretch(const LocalMesh &mesh, const double stretch, const double angle)
  {
    return nodal_field(mesh, [&](const Vector &X) -> Vector {
      const Vector Y = {
        X[0] + stretch * (X[0] + X[1] * X[2]), X[1] - stretch * X[0] * X[1], X[2] + stretch * X[1]};
      const double c = std::cos(angle), s = std::sin(angle), a = std::cos(0.4), b = std::sin(0.4);
      // about the axis (0, a, b)
      const double along = a * Y[1] + b * Y[2], across = -b * Y[1] + a * Y[2];
      const double x = c * Y[0] + s * across, turned = c * across - s * Y[0];
      return {x - X[0], a * along - b * turned - X[1], b * along + a * turned - X[2] + 3};
    });
  }

  void
  finite_rotation()
  {
    const LocalMesh mesh  = distorted_block();
    const double    angle = 10 * 2 * M_PI + 1;
    ElementEnergy   still, turned;
    BOOST_TEST(near(largest(internal_force(mesh, turned_stretch(mesh, 0, angle), still)) / 210e9,
                    0,
                    1e-13,
                    "ten turns and a translation: force over Young's modulus"));
    // a stretched body keeps its energy when it is turned
    still             = ElementEnergy();
    const auto f      = internal_force(mesh, turned_stretch(mesh, 0.02, 0), still);
    const auto g      = internal_force(mesh, turned_stretch(mesh, 0.02, angle), turned);
    double     change = 0;
    for (std::size_t n = 0; n < mesh.n_nodes(); ++n)
      change = std::max(change,
                        std::abs(std::hypot(f[4 * n], f[4 * n + 1], f[4 * n + 2]) -
                                 std::hypot(g[4 * n], g[4 * n + 1], g[4 * n + 2])));
    BOOST_TEST(near(turned.strain / still.strain, 1, 1e-11, "energy of a stretched block after ten turns"));
    BOOST_TEST(near(change / largest(f), 0, 1e-11, "magnitudes of its forces after ten turns"));
  }

  void
  energy_gradient()
  {
    const LocalMesh                        mesh = distorted_block();
    auto                                   u    = turned_stretch(mesh, 0.02, 2);
    std::mt19937                           random(3);
    std::uniform_real_distribution<double> value(-0.01, 0.01);
    for (double &x : u)
      x += value(random);
    ElementEnergy ignored;
    const auto    f     = internal_force(mesh, u, ignored);
    double        worst = 0;
    for (std::size_t k = 0; k < u.size(); k += k % 4 == 2 ? 2 : 1)
      {
        const double h = 1e-5, at = u[k];
        double       W[2];
        for (int side = 0; side < 2; ++side)
          {
            u[k] = at + (side == 0 ? -h : h);
            ElementEnergy energy;
            internal_force(mesh, u, energy);
            W[side] = energy.strain;
          }
        u[k]  = at;
        worst = std::max(worst, std::abs((W[1] - W[0]) / (2 * h) - f[k]));
      }
    BOOST_TEST(near(worst / largest(f), 0, 1e-7, "force is the exact gradient of the energy"));

    double force[3] = {}, moment[3] = {};
    for (std::size_t n = 0; n < mesh.n_nodes(); ++n)
      for (int i = 0; i < 3; ++i)
        {
          const int j = (i + 1) % 3, k = (i + 2) % 3;
          force[i] += f[4 * n + i];
          moment[i] += (mesh.reference[4 * n + j] + u[4 * n + j]) * f[4 * n + k] -
                       (mesh.reference[4 * n + k] + u[4 * n + k]) * f[4 * n + j];
        }
    for (int i = 0; i < 3; ++i)
      {
        BOOST_TEST(near(force[i] / largest(f), 0, 1e-12, "internal forces sum to zero"));
        BOOST_TEST(near(moment[i] / largest(f), 0, 1e-12, "internal moments sum to zero"));
      }
  }

  void
  widths_and_linearisation()
  {
    const LocalMesh                        mesh     = distorted_block();
    const auto                             geometry = cell_geometry(mesh);
    std::mt19937                           random(5);
    std::uniform_real_distribution<double> value(-1e-9, 1e-9);
    const auto                             u = nodal_field(mesh, [&](const Vector &) -> Vector {
      return {value(random), value(random), value(random)};
    });
    ElementEnergy                          one;
    const auto                             f1 = internal_force(mesh, u, one, 1);
    for (const int width : {2, 4, 8})
      {
        ElementEnergy energy;
        auto          f = internal_force(mesh, u, energy, width);
        for (std::size_t k = 0; k < f.size(); ++k)
          f[k] -= f1[k];
        BOOST_TEST(
          near(largest(f) / largest(f1), 0, 1e-14, "width " + std::to_string(width) + " equals width 1"));
        BOOST_TEST(near(energy.strain / one.strain, 1, 1e-14, "and so does its energy"));
      }
    AlignedVector<double> linear(u.size(), 0.);
    for (std::size_t e = 0; e < mesh.cells.size(); ++e)
      {
        const auto  K    = element_stiffness(geometry[e], Elasticity(), ElementForm::full);
        const auto &cell = mesh.cells[e];
        for (int r = 0; r < 24; ++r)
          for (int c = 0; c < 24; ++c)
            linear[4 * cell[r / 3] + r % 3] += K[24 * r + c] * u[4 * cell[c / 3] + c % 3];
      }
    for (std::size_t k = 0; k < linear.size(); ++k)
      linear[k] -= f1[k];
    BOOST_TEST(near(largest(linear) / largest(f1), 0, 1e-7, "stiffness matrix is the linearised kernel"));
  }

  /// Uniaxial tension to 450 MPa and back to -500 MPa of a bilinear material, against the closed form:
  /// the Green strains of the exact answer are imposed on distorted cells.
  void
  plastic_uniaxial(const double kinematic)
  {
    const LocalMesh  mesh = distorted_block();
    const Elasticity steel;
    const Plasticity law{300e6, 21e9, kinematic};
    const double     E = steel.youngs_modulus, nu = steel.poissons_ratio, H = law.hardening_modulus(steel);
    const double     first = 450e6, last = -500e6;
    const double     strain   = (first - 300e6) / H;
    const double     reversed = kinematic * H * strain - (300e6 + (1 - kinematic) * H * strain);
    const double     back     = (reversed - last) / H; // plastic strain that the way back takes off
    struct Stage
    {
      double stress, strain, work;
    };
    const double pulled = strain * (300e6 + first) / 2, pushed = back * -(reversed + last) / 2;
    for (const int width : {1, native_width})
      {
        ElementBlocks blocks =
          pack_elements(cell_geometry(mesh), mesh.cells, BilinearLaw(steel, law), width, ElementForm::full);
        for (const Stage &stage : {Stage{200e6, 0, 0},
                                   Stage{first, strain, pulled},
                                   Stage{0, strain, pulled},
                                   Stage{last, strain - back, pulled + pushed}})
          {
            const double          Ex = stage.stress / E + stage.strain;
            const double          Ey = -nu * stage.stress / E - stage.strain / 2;
            const double          Fx = std::sqrt(1 + 2 * Ex), Fy = std::sqrt(1 + 2 * Ey);
            const auto            u = nodal_field(mesh, [&](const Vector &X) -> Vector {
              return {(Fx - 1) * X[0], (Fy - 1) * X[1], (Fy - 1) * X[2]};
            });
            AlignedVector<double> f(u.size(), 0.);
            ElementEnergy         energy;
            subtract_internal_force(blocks, u.data(), f.data(), BulkViscosity(), true, energy);
            double worst = 0;
            for (std::size_t e = 0; e < mesh.cells.size(); ++e)
              for (const auto &s : full_point_stress(blocks, e, u.data()))
                for (int k = 0; k < 6; ++k)
                  worst = std::max(worst, std::abs(s[k] - (k == 0 ? stage.stress * Fx / (Fy * Fy) : 0.)));
            double volume = 0;
            for (const double V : blocks.volume)
              volume += V;
            const std::string text = "stress " + std::to_string(stage.stress / 1e6) +
                                     " MPa, kinematic part " + std::to_string(kinematic) + ", width " +
                                     std::to_string(width);
            BOOST_TEST(near(worst / E, 0, 1e-14, text + ": largest error at any point over E"));
            BOOST_TEST(near(energy.strain / volume,
                            stage.stress * stage.stress / (2 * E),
                            1e-10 * E * 1e-6,
                            text + ": elastic energy density [J/m3]"));
            BOOST_TEST(near(energy.plastic_work / volume,
                            stage.work,
                            1e-10 * E * 1e-6,
                            text + ": plastic work density [J/m3]"));
          }
      }
  }

  void
  rigid_modes()
  {
    for (const double nu : {0., 0.3, 0.4999})
      {
        Elasticity material;
        material.poissons_ratio = nu;
        double zero = 0, lowest = 1e300;
        for (const auto &g : cell_geometry(distorted_block()))
          {
            const auto                       K = element_stiffness(g, material, ElementForm::full);
            dealii::LAPACKFullMatrix<double> matrix(24, 24);
            double                           asymmetry = 0;
            for (int r = 0; r < 24; ++r)
              for (int c = 0; c < 24; ++c)
                {
                  matrix(r, c) = K[24 * r + c];
                  asymmetry    = std::max(asymmetry, std::abs(K[24 * r + c] - K[24 * c + r]));
                }
            dealii::FullMatrix<double> vectors;
            dealii::Vector<double>     values;
            matrix.compute_eigenvalues_symmetric(-1e300, 1e300, 0, values, vectors);
            zero   = std::max({zero, std::abs(values[5]) / values[23], asymmetry / values[23]});
            lowest = std::min(lowest, values[6] / (material.shear_modulus() * std::cbrt(g.volume)));
          }
        BOOST_TEST(near(zero, 0, 1e-13, "six modes without stiffness, nu = " + std::to_string(nu)));
        BOOST_TEST(lowest > 0.01,
                   "and no seventh: lowest stiffness over mu L is " + std::to_string(lowest) +
                     ", nu = " + std::to_string(nu));
      }
  }
} // namespace


BOOST_FIXTURE_TEST_CASE(full_element, test::Parallel)
{
  patch_test();
  finite_rotation();
  energy_gradient();
  widths_and_linearisation();
  for (const double kinematic : {0., 0.4, 1.})
    plastic_uniaxial(kinematic);
  rigid_modes();
}
