#pragma once

#include "meshes.h"

#include <mpi.h>

namespace scenes
{
  /// The part of a mesh on one rank that this one of several ranks holds: an equal share of the cells in
  /// their order, the nodes numbered in the order of their first use; keys are the numbers in the whole mesh.
  /// Meshes with hanging nodes are refused (std::logic_error). Collective.
  LocalMesh
  rank_part(const LocalMesh &whole, MPI_Comm communicator);
} // namespace scenes
