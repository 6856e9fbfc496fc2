#pragma once

#include <wheelrail/contact/contact.h>
#include <wheelrail/halfspace/tangential.h>

#include <vector>

namespace wheelrail
{
  /// Inclination of the wheel's surface to the horizontal at s [rad].
  double
  inclination(const RunningSurfaces &surfaces, double s);

  /// Loaded nodes of the lattice in one plane, with one line around them, as a half-space grid: x along the
  /// track relative to the axle's lowest line, y across along the plane, rail as body 1. Every node has
  /// `parts` x `parts` elements, an odd number: with one element a node, the creepage on 2 mm cells comes out
  /// 6 % too small. Sixty elements over the shorter extent are enough for any patch.
  struct StartGrid
  {
    int           first_i = 0, first_j = 0; ///< the first node
    int           n_i = 0, n_j = 0;         ///< nodes along and across
    int           parts   = 1;
    double        s_first = 0, s_step = 0; ///< of the rows of elements, across along the frame [m]
    HalfspaceGrid grid;

    std::size_t
    node(const Lattice &lattice, const int i, const int j) const
    {
      return lattice.index(first_i + i, first_j + j);
    }
    /// Element (a, b) of node (i, j).
    std::size_t
    element(const int i, const int j, const int a, const int b) const
    {
      return parts * i + a + std::size_t(grid.mx) * (parts * j + b);
    }
    /// s of a row of elements, in the frame of the contact.
    double
    s(const int row) const
    {
      return s_first + row * s_step;
    }
  };

  /// The grids of a contact; none without pressure. Loaded columns beside one another are a patch; patches
  /// beside one another whose inclinations, as means over their pressure, differ by less than `same_plane`
  /// are one grid.
  std::vector<StartGrid>
  start_grids(const Contact &contact);

  /// Pressures of the elements [Pa]: p^2, which falls to the edge of a patch as a straight line, is
  /// bilinear between the nodes, and the elements of each node have its pressure in the mean.
  std::vector<double>
  element_pressures(const Contact &contact, const StartGrid &loaded);

  /// Pressures in the middle of the step of one element that steady rolling is found by: the mean of those
  /// of an element and of the one behind it. Tractions are those of the ends of such steps; with pressures
  /// of the same instant what sticks would begin half an element ahead of the patch, and the contact would
  /// be too stiff by as much (doc/theory/accuracy.md). The half that no element ahead takes stays, so that
  /// the sum does.
  std::vector<double>
  in_midst_of_step(const HalfspaceGrid &grid, const std::vector<double> &pressure);

  /// Tractions at the places of the elements, of those found half an element behind: the mean of an element
  /// and of the one ahead. Where both slide they have what friction allows there.
  VectorField
  at_elements(const HalfspaceGrid       &grid,
              const std::vector<double> &pressure,
              const HalfspaceSolution   &behind);
} // namespace wheelrail
