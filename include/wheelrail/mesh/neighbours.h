#pragma once

#include <wheelrail/mesh/local_mesh.h>

#include <mpi.h>

namespace wheelrail
{
  /// Fills `neighbours` and `owned` of a mesh from its global nodes: the nodes that several ranks hold, and
  /// whether this rank is the lowest that holds each. Collective.
  void
  find_neighbours(LocalMesh &mesh, MPI_Comm communicator);
} // namespace wheelrail
