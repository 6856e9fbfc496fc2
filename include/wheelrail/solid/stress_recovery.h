#pragma once

#include <wheelrail/solid/solid.h>

#include <array>
#include <vector>

namespace wheelrail
{
  /// Nodal stresses from those of the elements' centres, `stress` of rail and wheel in the order of their
  /// blocks: 6 numbers a node, xx yy zz yz xz xy [Pa].
  /// Linear stresses come out exactly, at surfaces too; where a body is one element thick, only along it.
  ///
  ///     s_n = mean(s) - mean(G) mean(d)
  ///
  /// mean: over the elements around the node, weighted by volume; d: from the node to the centre
  /// (reference); G: gradient of stress at the centre by least squares over all elements that share a node
  /// with the element, as over the patches of Zienkiewicz and Zhu (Int. J. Numer. Meth. Eng. 33, 1992, 1331).
  /// Nodes of elements that have flowed keep mean(s), which stays within the yield surface. Collective.
  std::vector<double>
  recovered_stress(const Solid                                       &solid,
                   const PerBody<std::vector<std::array<double, 6>>> &stress,
                   MPI_Comm                                           communicator);

  /// The present Cauchy stresses, recovered. Collective.
  std::vector<double>
  nodal_stress(const Solid &solid, MPI_Comm communicator);
} // namespace wheelrail
