#pragma once

// Bricks of reduced hexahedra moved by hand, for the tests of elements.

#include <wheelrail/mesh/local_mesh.h>
#include <wheelrail/solid/kernel.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <random>
#include <vector>

namespace test
{
  using namespace wheelrail;
  using Vector = std::array<double, 3>;

  struct Mesh
  {
    std::vector<Vector>                      vertices;
    std::vector<std::array<unsigned int, 8>> cells;
    std::vector<ElementGeometry>             geometry;
    int                                      n[3];

    unsigned int
    node(const int i, const int j, const int k) const
    {
      return i + (n[0] + 1) * (j + (n[1] + 1) * k);
    }
  };

  /// A brick of n cells; inner vertices moved at random by `distortion` of a
  /// cell.
  inline Mesh
  brick(const std::array<int, 3> &n, const Vector &size, const double distortion = 0)
  {
    Mesh mesh;
    std::copy(n.begin(), n.end(), mesh.n);
    std::mt19937                           random(7);
    std::uniform_real_distribution<double> shift(-distortion, distortion);
    for (int k = 0; k <= n[2]; ++k)
      for (int j = 0; j <= n[1]; ++j)
        for (int i = 0; i <= n[0]; ++i)
          {
            Vector X = {double(i), double(j), double(k)};
            for (int c = 0; c < 3; ++c)
              X[c] = (X[c] + shift(random)) * size[c] / n[c];
            mesh.vertices.push_back(X);
          }
    for (int k = 0; k < n[2]; ++k)
      for (int j = 0; j < n[1]; ++j)
        for (int i = 0; i < n[0]; ++i)
          {
            std::array<unsigned int, 8> cell;
            std::array<Vector, 8>       X;
            for (int a = 0; a < 8; ++a)
              {
                cell[a] = mesh.node(i + (a & 1), j + (a >> 1 & 1), k + (a >> 2));
                X[a]    = mesh.vertices[cell[a]];
              }
            mesh.cells.push_back(cell);
            mesh.geometry.push_back(element_geometry(X));
          }
    return mesh;
  }

  inline std::vector<ElementGeometry>
  cell_geometry(const LocalMesh &mesh)
  {
    std::vector<ElementGeometry> geometry;
    for (const auto &cell : mesh.cells)
      {
        std::array<Vector, 8> X;
        for (int a = 0; a < 8; ++a)
          for (int i = 0; i < 3; ++i)
            X[a][i] = mesh.reference[4 * cell[a] + i];
        geometry.push_back(element_geometry(X));
      }
    return geometry;
  }

  /// A body whose displacement is given.
  struct Brick
  {
    Mesh                  mesh;
    ElementBlocks         blocks;
    AlignedVector<double> u, f; ///< f: internal forces
    ElementEnergy         energy;

    Brick(const Mesh       &m,
          const Elasticity &material,
          const Plasticity &plasticity,
          const int         width = native_width)
      : mesh(m)
      , blocks(pack_elements(m.geometry, m.cells, material_law(material, plasticity), width))
      , u(4 * m.vertices.size(), 0.)
      , f(u)
    {
    }

    void
    find_force(const BulkViscosity &viscosity = {})
    {
      std::fill(f.begin(), f.end(), 0.);
      energy = ElementEnergy();
      subtract_internal_force(blocks, u.data(), f.data(), viscosity, true, energy);
      for (double &x : f)
        x = -x;
    }

    /// Sets a displacement and returns the work that goes with it, by the
    /// trapezoidal rule [J].
    double
    move_to(const AlignedVector<double> &target)
    {
      const auto before = f, from = u;
      u = target;
      find_force();
      double work = 0;
      for (std::size_t k = 0; k < u.size(); ++k)
        work += 0.5 * (before[k] + f[k]) * (u[k] - from[k]);
      return work;
    }

    double
    stored() const
    {
      return energy.strain + energy.stabilisation;
    }
  };

  inline AlignedVector<double>
  nodal(const Mesh &mesh, const std::function<Vector(const Vector &)> &field)
  {
    AlignedVector<double> u(4 * mesh.vertices.size(), 0.);
    for (std::size_t n = 0; n < mesh.vertices.size(); ++n)
      {
        const Vector value = field(mesh.vertices[n]);
        std::copy(value.begin(), value.end(), &u[4 * n]);
      }
    return u;
  }

  inline double
  largest(const AlignedVector<double> &x)
  {
    double m = 0;
    for (const double value : x)
      m = std::max(m, std::abs(value));
    return m;
  }

  inline double
  difference(const AlignedVector<double> &a, const AlignedVector<double> &b)
  {
    double m = 0;
    for (std::size_t k = 0; k < a.size(); ++k)
      m = std::max(m, std::abs(a[k] - b[k]));
    return m;
  }
} // namespace test
