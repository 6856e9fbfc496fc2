#pragma once

#include <wheelrail/solid/kernel.h>

#include <array>
#include <vector>

namespace wheelrail
{
  /// The `full` hexahedron: 2 x 2 x 2 Gauss points with the mean dilatation of the cell at all of them,
  /// so that it does not lock when the material is nearly incompressible. See doc/theory/element.md.

  /// Packs elements for the `full` kernel (rows: full_points.h). The last batch is filled up with
  /// copies of its first element whose eight nodes are one and the same: they have no strain.
  ElementBlocks
  pack_full_elements(const std::vector<ElementGeometry>             &geometry,
                     const std::vector<std::array<unsigned int, 8>> &cells,
                     const MaterialLaw                              &law,
                     int                                             width = kernel_width);

  /// As subtract_internal_force, for elements packed by pack_full_elements. The strain energy is that
  /// of the eight points; there is no stabilisation.
  void
  subtract_full_force(ElementBlocks       &blocks,
                      const double        *displacement,
                      double              *force,
                      const BulkViscosity &viscosity,
                      bool                 with_energy,
                      ElementEnergy       &energy);

  /// Cauchy stress [Pa] at the eight points of an element: xx, yy, zz, yz, xz, xy.
  std::array<std::array<double, 6>, 8>
  full_point_stress(const ElementBlocks &blocks, std::size_t element, const double *displacement);

  /// Volume mean of these.
  std::array<double, 6>
  full_mean_stress(const ElementBlocks &blocks, std::size_t element, const double *displacement);

  /// Volume mean of the displacement gradient, row-major [1].
  std::array<double, 9>
  full_mean_gradient(const ElementBlocks &blocks, std::size_t element, const double *displacement);

  /// 24 x 24 stiffness at rest, see element_stiffness.
  std::array<double, 24 * 24>
  full_element_stiffness(const std::array<std::array<double, 3>, 8> &vertices, const Elasticity &material);
} // namespace wheelrail
