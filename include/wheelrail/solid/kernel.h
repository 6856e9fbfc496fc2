#pragma once

#include <wheelrail/base/body.h>
#include <wheelrail/solid/element_blocks.h>

#include <array>
#include <vector>

namespace wheelrail
{
  /// Energies of the elements of one body [J, W].
  struct ElementEnergy
  {
    double strain        = 0; ///< elastic, of the one-point field
    double stabilisation = 0; ///< elastic, of the hourglass patterns
    double plastic_work  = 0; ///< done on plastic strains since the start, patterns included
    double hardening     = 0; ///< part of that which hardening stores
    double viscous_power = 0; ///< dissipated by the bulk viscosity, mean of the last step
  };

  /// Linear bulk viscosity: an extra isotropic stress b1 rho c L times the rate of dilatation, with
  /// L = 2 c / omega of the element, the edge of a cube and about the shortest edge of a flat cell (von
  /// Neumann and Richtmyer's linear term, as in Hallquist's manual; see doc/theory/element.md). The rate is
  /// the change of the trace of Green's strain since the last call over `time_step`. The power of a step is
  /// that of the mean of the extra stresses at both its ends: central differences let forces work along the
  /// means of two steps, and sums of it times the step are exact.
  struct BulkViscosity
  {
    double coefficient = 0;
    double time_step   = 0; ///< [s]; zero switches the viscosity off for this call
  };

  /// Subtracts the internal forces of all elements: force -= f_int(displacement).
  ///
  /// displacement and force hold 4 numbers a node (the last one unused) [m, N]. Total Lagrangian:
  /// Green's strain, second Piola-Kirchhoff stress of the Saint Venant-Kirchhoff law, and a
  /// stabilisation energy that is a function of Green-type measures too, so that any rigid motion
  /// leaves no force and momenta are conserved to round-off. Elements of a plastic material flow: the
  /// call brings their history up to date, so it must be made once a step and in the order of time.
  /// All SIMD widths (1, 2, 4, 8; blocks.width) give the same forces. Adds the viscous power to `energy`, and
  /// the other energies when `with_energy` is set.
  void
  subtract_internal_force(ElementBlocks       &blocks,
                          const double        *displacement,
                          double              *force,
                          const BulkViscosity &viscosity,
                          bool                 with_energy,
                          ElementEnergy       &energy);

  /// The same for the elements of both bodies.
  void
  subtract_internal_force(PerBody<ElementBlocks> &blocks,
                          const double           *displacement,
                          double                 *force,
                          const BulkViscosity    &viscosity,
                          bool                    with_energy,
                          ElementEnergy          &energy);

  /// Volume mean of the displacement gradient of one element, row-major [1].
  std::array<double, 9>
  element_gradient(const ElementBlocks &blocks, std::size_t element, const double *displacement);

  /// Cauchy stress [Pa] of each element: xx, yy, zz, yz, xz, xy; of plastic elements with the plastic
  /// strains of the last call of subtract_internal_force.
  std::vector<std::array<double, 6>>
  element_stress(const ElementBlocks &blocks, const double *displacement);
} // namespace wheelrail
