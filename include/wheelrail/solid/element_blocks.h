#pragma once

#include <wheelrail/base/simd.h>
#include <wheelrail/material/bilinear.h>

#include <array>
#include <cstdint>
#include <vector>

namespace wheelrail
{
  /// Geometry of one `reduced` hexahedron, all in the reference configuration.
  ///
  /// The one-point part is the uniform-gradient element of Flanagan and Belytschko (1981): B is the
  /// volume mean of the shape function gradients. The stabilisation acts on the four hourglass
  /// patterns h (eta zeta, zeta xi, xi eta, xi eta zeta), made blind to linear fields by
  /// gamma = h - B (h X); see doc/element.md.
  struct ElementGeometry
  {
    std::array<std::array<double, 3>, 8> B;           ///< mean gradient of each shape function [1/m]
    double                               volume;      ///< [m3]
    std::array<std::array<double, 3>, 4> hX;          ///< sum over nodes of h X for each pattern [m]
    std::array<std::array<double, 3>, 3> frame;       ///< columns: orthonormal axes closest to the cell's own
    std::array<double, 3>                half;        ///< half edge lengths along these axes [m]
    std::array<double, 8>                node_volume; ///< row sums of the consistent mass over density [m3]
  };

  /// Computes the geometry from the eight vertices in lexicographic order.
  /// Throws RunError when the Jacobian is not positive at a Gauss point.
  ElementGeometry
  element_geometry(const std::array<std::array<double, 3>, 8> &vertices);

  /// Largest squared angular frequency of an endless regular mesh of such elements with the smallest
  /// nodal share of the volume at every node [1/s2]. Exact for bricks inside a body and on smooth
  /// surfaces; nodes at free edges go a few per cent beyond it, see doc/element.md.
  double
  element_frequency_bound(const ElementGeometry &geometry, const Elasticity &material);

  /// The elements of one body packed in batches of `width` for the kernel: per batch
  /// `fields` x `width` numbers and 8 x `width` node numbers. The last batch is filled up with
  /// copies of its first element with zero volume and stiffness.
  struct ElementBlocks
  {
    /// Rows of the packed data: B (24), volume, hX (12), frame (9), scaled inverse half lengths (3),
    /// length of the bulk viscosity (1).
    static constexpr int fields = 24 + 1 + 12 + 9 + 3 + 1;

    int                          width = native_width;
    Elasticity                   material;
    std::size_t                  n_elements = 0;
    AlignedVector<double>        data;
    AlignedVector<std::uint32_t> nodes;
    AlignedVector<double> dilatation; ///< trace of Green's strain at the last step, for the bulk viscosity

    std::size_t
    n_batches() const
    {
      return nodes.size() / (8 * width);
    }
  };

  /// Packs elements given by their geometry and local nodes.
  ElementBlocks
  pack_elements(const std::vector<ElementGeometry>             &geometry,
                const std::vector<std::array<unsigned int, 8>> &cells,
                const Elasticity                               &material,
                int                                             width = native_width);

  /// 24 x 24 stiffness of the element at rest [N/m], row-major, row = 3 node + component: the exact
  /// linearisation of the kernel, used by the static start.
  std::array<double, 24 * 24>
  element_stiffness(const ElementGeometry &geometry, const Elasticity &material);
} // namespace wheelrail
