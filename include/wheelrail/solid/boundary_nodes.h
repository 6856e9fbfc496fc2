#pragma once

#include <wheelrail/mesh/local_mesh.h>

#include <vector>


namespace wheelrail
{
  /// Nodes of this rank that lie on faces of its own cells with the given mark, once each, ascending.
  std::vector<unsigned int>
  boundary_nodes(const LocalMesh &mesh, Boundary mark);

  /// Nodes of this rank that lie on faces with the given mark on any rank, once each, ascending: a rank may
  /// hold a node of the boundary without a face there. Collective.
  std::vector<unsigned int>
  held_boundary_nodes(const LocalMesh &mesh, Boundary mark);
} // namespace wheelrail
