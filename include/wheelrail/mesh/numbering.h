#pragma once

#include <wheelrail/mesh/local_mesh.h>

#include <cstdint>
#include <vector>

#include <mpi.h>

namespace wheelrail
{
  /// Numbers cells and nodes so that any partition of the same mesh gives the same numbers: cells in the
  /// order of their cell_key (unique over all ranks), nodes in the order of the first (cell number, vertex)
  /// that has them. Fills cell_number and node_number of a mesh whose neighbours are known. Collective.
  void
  number_cells_and_nodes(LocalMesh &mesh, MPI_Comm communicator);
} // namespace wheelrail
