#pragma once

// The mesh of wheel and rail as p4est and deal.II make it from the rule of refinement alone, to judge that of
// the program by: p4est divides the cells that neighbours need, deal.II finds the nodes that hang and the
// boundary.

#include <wheelrail/mesh/discretization.h>

#include <cstdint>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace test
{
  /// A whole mesh by the keys of its cells and nodes.
  struct MeshByKeys
  {
    std::set<std::uint64_t> cells, nodes;
    std::set<std::uint64_t> outer; ///< nodes on any boundary; of p4est's mesh alone
    /// Parents of each hanging node, with their weights, ascending.
    std::map<std::uint64_t, std::vector<std::pair<std::uint64_t, double>>> hanging;
  };

  /// By p4est, with finest cells in `zones`. Collective.
  MeshByKeys
  p4est_mesh(const wheelrail::Discretization               &discretization,
             const wheelrail::PerBody<wheelrail::FineZone> &zones,
             MPI_Comm                                       communicator);

  /// The parts that all ranks hold of the program's mesh. Collective.
  MeshByKeys
  program_mesh(const wheelrail::LocalMesh &mesh, MPI_Comm communicator);
} // namespace test
