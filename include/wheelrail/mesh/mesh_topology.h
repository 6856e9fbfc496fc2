#pragma once

#include <wheelrail/base/vector3.h>
#include <wheelrail/mesh/local_mesh.h>
#include <wheelrail/mesh/swept_grid.h>

#include <array>
#include <cstdint>
#include <unordered_map>
#include <utility>
#include <vector>

namespace wheelrail
{
  /// Nodes of a list of cells that cover both bodies with 2 : 1 over faces and edges, the same on every rank:
  /// a vertex is known by its key, and nodes in the middle of an edge or a face of a cell hang on its ends or
  /// corners.
  struct MeshTopology
  {
    using Corners = std::array<std::uint32_t, 8>;
    /// A hanging node's parents, which do not hang themselves, with their weights, ascending.
    using Parents = std::vector<std::pair<std::uint32_t, double>>;

    /// Nodes have numbers in the order in which the cells use them.
    MeshTopology(const std::vector<CellPlace> &cells, const PerBody<SweptGrid> &grids);

    const std::vector<CellPlace> &cells;
    std::vector<Corners>          corners;  ///< of each cell, lexicographic
    std::vector<std::uint64_t>    key;      ///< of each node, see SweptGrid::vertex_key()
    std::vector<Vector3>          position; ///< of each node, before hanging ones are moved [m]
    std::unordered_map<std::uint64_t, std::uint32_t> node; ///< of a key
    std::unordered_map<std::uint32_t, Parents>       hanging;
  };

  /// The places around a cell in halves of its edges, 0 to 2 in each direction: its vertices, and the middles
  /// of its edges, faces and of itself.
  struct HalfPlace
  {
    std::array<int, 3>        place;
    std::vector<unsigned int> parents; ///< the vertices of the cell whose mean it is, each of equal weight
  };
  const std::vector<HalfPlace> &
  half_places();

  /// Key of such a place; `size` is that of the cell in finest ones and has to be even for middles.
  std::uint64_t
  half_place_key(const CellPlace &cell, const std::array<int, 3> &place, const SweptGrid &grid);

  /// A stretch [begin, end) of the cells of a mesh.
  struct CellStretch
  {
    std::size_t begin, end;
  };

  /// An even share of n cells.
  CellStretch
  share_of_rank(std::size_t n, int rank, int size);

  /// The cells whose nodes a rank holds, and those of them that it works on.
  struct RankCells
  {
    CellStretch held, own;

    explicit RankCells(const CellStretch &cells)
      : held(cells)
      , own(cells)
    {
    }
    RankCells(const CellStretch &of_nodes, const CellStretch &worked_on)
      : held(of_nodes)
      , own(worked_on)
    {
    }
  };

  /// A rank's part of a mesh: nodes, those that hang, cells, and which other ranks hold a node; global_node
  /// counts as the topology does. No message is sent. Faces, keys of cells and lasting numbers are left
  /// empty.
  LocalMesh
  rank_mesh(const MeshTopology &mesh, const std::vector<RankCells> &shares, int rank);
} // namespace wheelrail
