#pragma once

#include <wheelrail/mesh/local_mesh.h>

#include <mpi.h>

namespace wheelrail
{
  /// Finds which ranks hold the nodes of a rank's mesh, by their keys: fills `neighbours` and `owned`.
  /// Collective.
  void
  find_neighbours(LocalMesh &mesh, MPI_Comm communicator);
} // namespace wheelrail
