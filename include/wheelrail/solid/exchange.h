#pragma once

#include <wheelrail/mesh/local_mesh.h>

#include <cstddef>

namespace wheelrail
{
  /// Adds up the parts that the ranks have of nodal values, `numbers` a node; the owner of a node tells the
  /// sum to all that hold it, so that they go on integrating the node alike, to the bit. Collective.
  void
  sum_over_ranks(const LocalMesh &mesh, double *values, std::size_t numbers = 4);

  /// Moves the values of hanging nodes to their parents: parent += weight x value; value = 0. Four numbers a
  /// node, which are taken at once: the first one stands at a multiple of 32 bytes (AlignedVector).
  void
  condense(const LocalMesh &mesh, double *values);

  /// Gives hanging nodes the weighted mean of their parents; values as for condense().
  void
  distribute(const LocalMesh &mesh, double *values);
} // namespace wheelrail
