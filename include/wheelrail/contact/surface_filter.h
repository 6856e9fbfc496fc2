#pragma once

#include <wheelrail/contact/surface.h>

#include <array>
#include <vector>

namespace wheelrail
{
  /// Filter of the surface lattice that makes its discrete response the exact one to second order in
  /// the cell size, see doc/theory/contact.md. Zero weights filter nothing.
  struct SurfaceFilter
  {
    double normal = 0; ///< weight for positions and pressures, along and across
    double shear  = 0; ///< weight for slip and shear tractions: each component across its own direction only
  };

  /// Weights of one field: [component] along the track and across it.
  struct FilterWeights
  {
    Vector3 along{}, across{};
  };

  FilterWeights
  normal_weights(const SurfaceFilter &filter);

  /// Components X, Y are filtered along the track, Z across it.
  FilterWeights
  shear_weights(const SurfaceFilter &filter);

  /// Filters a field of the surface lattice over the stations [first, last), in place.
  ///
  /// Each value gets weight / 2 times the sum of the differences to its neighbours, across the track
  /// and then along it: S = I - weight / 2 D^T D in each direction, D the differences of neighbours.
  /// S is symmetric, its rows and columns sum to one, and it keeps fields that are linear over the
  /// lattice (one row inside the border). So velocities filtered by S and forces filtered by the same
  /// S have the same power, and forces and moments are conserved.
  void
  filter_surface(const Lattice        &lattice,
                 int                   first,
                 int                   last,
                 const FilterWeights  &weights,
                 std::vector<Vector3> &field);

  /// Weight of the nodes around the node (i, j) in its filtered value, 3 x 3, first index along the
  /// track; the same in both directions, on a lattice of the stations [first, last).
  std::array<std::array<double, 3>, 3>
  filter_stencil(const Lattice &lattice, int first, int last, double weight, int i, int j);
} // namespace wheelrail
