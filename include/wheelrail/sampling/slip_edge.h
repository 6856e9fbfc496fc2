#pragma once

#include <wheelrail/output/hdf5_file.h>

namespace wheelrail
{
  /// Points of a contact patch at which its shear traction peaks between the nodes.
  ///
  /// In rolling the shear traction has a sharp peak on the line between stick and slip: it follows the
  /// friction bound on the slipping side and falls with a vertical tangent on the sticking side, so the
  /// largest nodal value can be low by several per cent on cells of a twelfth of the patch. The line is
  /// therefore sought on every grid line along the track between a slipping and a sticking node. There
  /// the shortfall q = bound - traction (vectors; the bound points as the traction of the slipping node)
  /// falls to zero like the root of the distance (Carter, 1926; Haines and Ollerton, 1963: every strip
  /// of the patch), so q^2 is extrapolated by the parabola through three sticking nodes, or by the line
  /// through two. The traction on the line is the pressure there, by the polynomial through up to four
  /// nodes, times the traction coefficient of the slipping node. Lines on which q does not grow into the
  /// sticking side, or does not vanish within the cell, have no point.
  SlipEdge
  slip_edge(const PatchFields &patch);

  /// Largest shear traction of a contact patch [Pa], at its nodes and on its slip_edge().
  double
  largest_shear(const PatchFields &patch);
} // namespace wheelrail
