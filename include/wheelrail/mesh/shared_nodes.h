#pragma once

#include <wheelrail/mesh/local_mesh.h>

#include <vector>

#include <mpi.h>

namespace wheelrail
{
  /// Makes the partitioner of a mesh whose nodes are numbered over all ranks, the rank's own ones first.
  /// Collective.
  void
  share_nodes(LocalMesh &mesh, MPI_Comm communicator);

  /// Numbers nodes that are known by their keys over all ranks, each owned by the lowest rank that holds it,
  /// puts them in this order and makes the partitioner. Gives the new local number of each. Collective.
  std::vector<unsigned int>
  number_nodes(LocalMesh &mesh, MPI_Comm communicator);
} // namespace wheelrail
