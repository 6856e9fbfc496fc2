#pragma once

#include <wheelrail/base/simd.h>
#include <wheelrail/material/material_law.h>
#include <wheelrail/solid/element_form.h>

#include <array>
#include <cstdint>
#include <vector>

namespace wheelrail
{
  /// Elements in a batch unless asked otherwise: 8 where the machine has AVX-512, else 4 or 2. See
  /// doc/theory/element.md.
  constexpr int kernel_width = native_width < 8 ? native_width : 8;

  /// Geometry of one hexahedron, all in the reference configuration.
  ///
  /// For the form `full` the vertices would do. The one-point part of `reduced` is the uniform-gradient
  /// element of Flanagan and Belytschko (1981): B is the volume mean of the shape function gradients. The
  /// stabilisation acts on the four hourglass patterns h (eta zeta, zeta xi, xi eta, xi eta zeta), made blind
  /// to linear fields by gamma = h - B (h X); see doc/theory/element.md.
  struct ElementGeometry
  {
    std::array<std::array<double, 3>, 8> B;           ///< mean gradient of each shape function [1/m]
    double                               volume;      ///< [m3]
    std::array<std::array<double, 3>, 4> hX;          ///< sum over nodes of h X for each pattern [m]
    std::array<std::array<double, 3>, 3> frame;       ///< columns: orthonormal axes closest to the cell's own
    std::array<double, 3>                half;        ///< half edge lengths along these axes [m]
    std::array<std::array<double, 3>, 8> vertices;    ///< reference positions [m]
    std::array<double, 8>                node_volume; ///< row sums of the consistent mass over density [m3]
  };

  /// Computes the geometry from the eight vertices in lexicographic order.
  /// Throws RunError when the Jacobian is not positive at a Gauss point.
  ElementGeometry
  element_geometry(const std::array<std::array<double, 3>, 8> &vertices);

  /// Largest squared angular frequency of an endless regular mesh of such elements with the smallest
  /// nodal share of the volume at every node [1/s2]. Exact for bricks inside a body and on smooth
  /// surfaces; nodes at free edges go a few per cent beyond it, see doc/theory/element.md.
  double
  element_frequency_bound(const ElementGeometry &geometry, const Elasticity &material);

  /// The elements of one body packed in batches of `width` for the kernel: per batch `rows` x
  /// `width` numbers, whose meaning depends on the form, and 8 x `width` node numbers. The last batch
  /// is filled up with lanes that bear no force and have no energy.
  struct ElementBlocks
  {
    /// Rows of the form `reduced`: B (24), volume, hX (12), frame (9), scaled inverse half lengths
    /// (3), length of the bulk viscosity (1).
    static constexpr int fields = 24 + 1 + 12 + 9 + 3 + 1;
    /// Rows of the history of the hourglass amplitudes in that form.
    static constexpr int amplitude_rows = 12;

    ElementForm                  form  = ElementForm::reduced;
    int                          width = kernel_width;
    int                          rows  = fields;
    MaterialLaw                  law;
    std::size_t                  n_elements = 0;
    AlignedVector<double>        data;
    AlignedVector<std::uint32_t> nodes;
    std::vector<double>          volume; ///< of each element [m3]
    /// For the bulk viscosity, per batch 2 x `width` numbers: trace of Green's strain [1] and the extra
    /// stress [Pa] at the last step.
    AlignedVector<double> viscous;

    // What plastic flow leaves behind; all empty in elastic bodies.

    /// Per batch `history_rows()` x `width` numbers: those of the law for each integration point,
    /// then, in the form `reduced`, the 12 plastic parts of the hourglass amplitudes [m].
    AlignedVector<double>      history;
    AlignedVector<double>      plastic_work; ///< of each element so far, in the order of the lanes [J]
    std::vector<unsigned char> flowed;       ///< of each batch: whether its history differs from zero

    std::size_t
    n_batches() const
    {
      return nodes.size() / (8 * width);
    }
    int
    n_points() const
    {
      return form == ElementForm::full ? 8 : 1;
    }
    /// Zero when the law is elastic.
    int
    history_rows() const
    {
      const int of_point = wheelrail::history_rows(law);
      return of_point * n_points() + (of_point > 0 && form == ElementForm::reduced ? amplitude_rows : 0);
    }
    /// Whether the material may flow.
    bool
    plastic() const
    {
      return history_rows() > 0;
    }
    /// Constants of the elastic part of the law.
    const Elasticity &
    elasticity() const
    {
      return wheelrail::elasticity(law);
    }
  };

  /// Calls visit(name, components, array) for every array of numbers per element that one step leaves to
  /// the next: all that a saved run needs of them. Such an array holds, per batch, `components` rows of
  /// `width` numbers. `flowed` follows from them, see mark_flowed().
  template <typename Blocks, typename Visit>
  void
  visit_histories(Blocks &blocks, const Visit &visit)
  {
    visit("bulk_viscosity", 2u, blocks.viscous);
    if (blocks.plastic())
      {
        visit("plastic_history", static_cast<unsigned int>(blocks.history_rows()), blocks.history);
        visit("plastic_work", 1u, blocks.plastic_work);
      }
  }

  /// Sets `flowed` of a plastic body from its history.
  void
  mark_flowed(ElementBlocks &blocks);

  /// Packs elements given by their geometry and local nodes, with a history of zeros.
  ElementBlocks
  pack_elements(const std::vector<ElementGeometry>             &geometry,
                const std::vector<std::array<unsigned int, 8>> &cells,
                const MaterialLaw                              &law,
                int                                             width = kernel_width,
                ElementForm                                     form  = ElementForm::reduced);

  /// Gives packed elements of any form another law of the same elastic constants, and a history of
  /// zeros.
  void
  set_law(ElementBlocks &blocks, const MaterialLaw &law);

  /// 24 x 24 stiffness of the element at rest [N/m], row-major, row = 3 node + component: the exact
  /// linearisation of the kernel, used by the static start.
  std::array<double, 24 * 24>
  element_stiffness(const ElementGeometry &geometry,
                    const Elasticity      &material,
                    ElementForm            form = ElementForm::reduced);
} // namespace wheelrail
