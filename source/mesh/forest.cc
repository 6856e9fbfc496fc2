#include <wheelrail/mesh/forest.h>
#include <wheelrail/mesh/mesh_topology.h>

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <utility>

namespace wheelrail
{
  namespace
  {
    /// Numbers of cells and nodes that neither the partition nor the order of the cells changes.
    struct LastingNumbers
    {
      std::vector<std::uint32_t> cell, node;
    };

    LastingNumbers
    lasting_numbers(const MeshTopology &mesh)
    {
      const std::size_t          n = mesh.cells.size();
      std::vector<std::uint64_t> key(n);
      std::transform(
        mesh.cells.begin(), mesh.cells.end(), key.begin(), [](const CellPlace &cell) { return cell.key(); });
      std::vector<std::uint32_t> order(n);
      std::iota(order.begin(), order.end(), 0);
      std::sort(order.begin(), order.end(), [&](const std::uint32_t a, const std::uint32_t b) {
        return key[a] < key[b];
      });
      constexpr std::uint32_t none = ~std::uint32_t(0);
      LastingNumbers          numbers{std::vector<std::uint32_t>(n),
                             std::vector<std::uint32_t>(mesh.key.size(), none)};
      std::uint32_t           cells = 0, nodes = 0;
      for (const std::uint32_t c : order)
        {
          numbers.cell[c] = cells++;
          for (const std::uint32_t node : mesh.corners[c])
            if (numbers.node[node] == none)
              numbers.node[node] = nodes++;
        }
      return numbers;
    }

    void
    add_faces(LocalMesh &local, const unsigned int c, const CellPlace &cell, const SweptGrid &grid)
    {
      // lexicographic corners of the faces of a lexicographic hexahedron
      constexpr unsigned int corner[6][4] = {
        {0, 2, 4, 6}, {1, 3, 5, 7}, {0, 1, 4, 5}, {2, 3, 6, 7}, {0, 1, 2, 3}, {4, 5, 6, 7}};
      const int  n     = 1 << cell.level;
      const bool at[6] = {cell.i == 0,
                          cell.i == n - 1,
                          cell.j == 0,
                          cell.j == n - 1,
                          !grid.closed() && cell.k == 0,
                          !grid.closed() && cell.k == grid.n_columns() * n - 1};
      for (unsigned int f = 0; f < 6; ++f)
        if (const Boundary mark = f < 4 ? grid.mark(cell.block, f) : Boundary::end;
            at[f] && mark != Boundary::free)
          {
            BoundaryFace face;
            for (unsigned int v = 0; v < 4; ++v)
              face.nodes[v] = local.cells[c][corner[f][v]];
            face.cell   = c;
            face.mark   = mark;
            face.body   = cell.body;
            face.finest = cell.level == grid.levels();
            face.strip  = grid.in_strip(cell.block);
            local.faces.push_back(face);
          }
    }
  } // namespace


  Forest::Forest(MPI_Comm communicator, SweepPlan plan)
    : plan_(std::move(plan))
    , grids_{SweptGrid(plan_, Body::rail), SweptGrid(plan_, Body::wheel)}
    , communicator_(communicator)
  {
    lay({{plan_.fine}, {plan_.fine}}, {0, 0});
  }


  void
  Forest::lay(const PerBody<FineZone> &zones, const PerBody<int> &first_column)
  {
    cells_ = CellTree(plan_, grids_, zones).leaves(first_column);
  }


  void
  Forest::lay_blocks(const Body body)
  {
    cells_ = CellTree(plan_, grids_, {}).leaves({0, 0});
    cells_.erase(std::remove_if(
                   cells_.begin(), cells_.end(), [body](const CellPlace &cell) { return cell.body != body; }),
                 cells_.end());
  }


  LocalMesh
  Forest::local_mesh() const
  {
    int rank, size;
    MPI_Comm_rank(communicator_, &rank);
    MPI_Comm_size(communicator_, &size);
    const MeshTopology     topology(cells_, grids_);
    std::vector<RankCells> shares;
    for (int r = 0; r < size; ++r)
      shares.push_back(RankCells(share_of_rank(cells_.size(), r, size)));
    LocalMesh            mesh    = rank_mesh(topology, shares, rank);
    const LastingNumbers numbers = lasting_numbers(topology);
    for (unsigned int c = 0; c < mesh.cells.size(); ++c)
      {
        const std::size_t whole = shares[rank].own.begin + c;
        const CellPlace  &cell  = cells_[whole];
        mesh.cell_key.push_back(cell.key());
        mesh.cell_number.push_back(numbers.cell[whole]);
        add_faces(mesh, c, cell, grids_[cell.body]);
      }
    for (const std::uint32_t node : mesh.global_node)
      mesh.node_number.push_back(numbers.node[node]);
    return mesh;
  }
} // namespace wheelrail
