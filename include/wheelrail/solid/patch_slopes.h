#pragma once

#include <wheelrail/base/simd.h>
#include <wheelrail/base/vector3.h>
#include <wheelrail/mesh/local_mesh.h>
#include <wheelrail/solid/exchange.h>

#include <array>
#include <vector>

/// Least squares over patches of elements: what the recovery of stresses (stress_recovery.h) is made of.
namespace wheelrail::patches
{
  using Stress = std::array<double, 6>; ///< xx yy zz yz xz xy [Pa]

  /// One element as the recovery sees it.
  struct Element
  {
    const std::array<unsigned int, 8> *nodes;
    Vector3                            centre; ///< in reference coordinates [m]
    Stress                             stress; ///< at the centre
    double                             volume; ///< [m3]
    bool                               flowed;
  };

  /// Sums over the elements around a point, weighted by volume; d counts from the point to the centres
  /// (reference).
  struct Moments
  {
    double                volume = 0;
    double                flowed = 0; ///< volume that has flowed
    Vector3               d{};
    std::array<double, 6> dd{}; ///< xx yy zz yz xz xy
    Stress                s{};
    std::array<Stress, 3> sd{}; ///< s times each component of d
  };

  /// Moments about each node of the elements around it. Collective.
  std::vector<Moments>
  nodal_moments(const LocalMesh &mesh, const std::vector<Element> &elements);

  /// The gradient of one element by least squares over its patch, and where a gradient that changes evenly
  /// has this value, from the element's centre.
  struct ElementGradient
  {
    std::array<Stress, 3> G;
    Vector3               place;
  };

  /// Of each element: the slope of the plane through the stresses of all elements that share a node with it,
  /// zero where all centres lie in one layer.
  std::vector<ElementGradient>
  element_gradients(const LocalMesh            &mesh,
                    const std::vector<Element> &elements,
                    const std::vector<Moments> &moments);

  /// Rows of a symmetric 3 x 3 matrix.
  using Rows = std::array<Vector3, 3>;

  double
  determinant(const Rows &row);

  /// Of a matrix that is not singular.
  Rows
  inverse(const Rows &row);

  /// Adds up what the ranks have for their shared nodes; Sums is a struct of doubles alone.
  template <typename Sums>
  void
  sum_over_ranks(const LocalMesh &mesh, std::vector<Sums> &sums)
  {
    wheelrail::sum_over_ranks(mesh, reinterpret_cast<double *>(sums.data()), sizeof(Sums) / sizeof(double));
  }
} // namespace wheelrail::patches
