#pragma once

#include <wheelrail/solid/solid.h>

#include <array>
#include <vector>

namespace wheelrail
{
  /// Stresses and their gradients at the nodes.
  struct NodalStress
  {
    std::vector<double> stress; ///< 6 numbers a node: xx yy zz yz xz xy [Pa]
    /// 18 numbers a node: the derivatives of the six along X, then Y, then Z of the reference [Pa/m]. Zero at
    /// nodes of elements that have flowed.
    std::vector<double> gradient;
  };

  /// Nodal stresses from those of the elements' centres, `stress` of rail and wheel in the order of their
  /// blocks. Linear stresses come out exactly, at surfaces too; where a body is one element thick, only along
  /// it. On bricks of one size quadratic ones do so inside of the body, since
  ///
  ///     s_n = mean(s) - mean(G) mean(d) - 1/2 (mean(G d) - mean(G) mean(d))
  ///
  /// mean: over the elements around the node, weighted by volume; d: from the node to the centre
  /// (reference); G: gradient of stress at the centre by least squares over all elements that share a node
  /// with the element, as over the patches of Zienkiewicz and Zhu (Int. J. Numer. Meth. Eng. 33, 1992, 1331).
  /// The last term takes out what a mean of centres flattens: h^2/8 times the Laplacian, a tenth of the
  /// stress below the edge of a contact on thirteen cells.
  /// Below surfaces, where the elements around one lie to one side of it, G is moved to its centre by the
  /// slope of the G around it, and quadratic stresses come out exactly at surfaces, too. What is still
  /// flattened is sought where the centres are given back from the nodes and added once more. Nodes of
  /// elements that have flowed have mean(s) alone, of stresses to which this is added: gradients change
  /// suddenly at the border of what has flowed, and would carry stresses beyond the yield surface.
  /// Collective.
  NodalStress
  recovered_stress(const Solid &solid, const PerBody<std::vector<std::array<double, 6>>> &stress);

  /// The present Cauchy stresses, recovered. Collective.
  NodalStress
  nodal_stress(const Solid &solid);
} // namespace wheelrail
