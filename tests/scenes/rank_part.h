#pragma once

#include "meshes.h"

namespace scenes
{
  /// The part of a mesh on one rank that one of several ranks holds: an equal share of the cells in their
  /// order, the nodes numbered in the order of their first use, and the nodes that other ranks hold too.
  /// Meshes with hanging nodes are refused (std::logic_error).
  LocalMesh
  rank_part(const LocalMesh &whole, unsigned int rank, unsigned int n_ranks);
} // namespace scenes
