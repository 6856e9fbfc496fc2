#pragma once

#include <deal.II/lac/la_parallel_vector.h>

#include <wheelrail/mesh/local_mesh.h>

namespace wheelrail
{
  /// Four numbers a node, the last one zero: those of the nodes that the rank owns, then room for those of
  /// others that it holds, in the numbers of its mesh. Products, norms and sums are of owned nodes;
  /// update_ghost_values() and compress() exchange the others.
  using NodeVector = dealii::LinearAlgebra::distributed::Vector<double>;

  /// Zeros.
  inline NodeVector
  node_vector(const LocalMesh &mesh)
  {
    return NodeVector(mesh.partitioner);
  }
} // namespace wheelrail
