#include <wheelrail/mesh/swept_mesh.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace wheelrail
{
  namespace
  {
    using Corners = std::array<std::uint32_t, 8>;

    /// A hanging node: its parents, which do not hang, with their weights, ascending.
    using Parents = std::vector<std::pair<std::uint32_t, double>>;

    /// The mesh of all ranks by its topology.
    struct WholeMesh
    {
      std::vector<CellPlace>                           cells;
      std::vector<Corners>                             corners;  ///< of each cell, lexicographic
      std::vector<std::uint64_t>                       key;      ///< of each node
      std::vector<Vector3>                             position; ///< of each node [m]
      std::unordered_map<std::uint64_t, std::uint32_t> node;     ///< of a key
      std::unordered_map<std::uint32_t, Parents>       hanging;
    };

    /// Size of a cell in finest ones, and its first corner in the finest lattice of its block and body.
    struct Extent
    {
      int size, i, j, k;
    };

    Extent
    extent(const CellPlace &cell, const unsigned int levels)
    {
      const int size = 1 << (levels - cell.level);
      return {size, cell.i * size, cell.j * size, cell.k * size};
    }

    void
    number_nodes(WholeMesh &mesh, const PerBody<SweptGrid> &grids)
    {
      mesh.node.reserve(2 * mesh.cells.size());
      for (const CellPlace &cell : mesh.cells)
        {
          const SweptGrid &grid = grids[cell.body];
          const Extent     e    = extent(cell, grid.levels());
          Corners          corners;
          for (unsigned int v = 0; v < 8; ++v)
            {
              const int i = e.i + (v & 1) * e.size, j = e.j + (v >> 1 & 1) * e.size,
                        k               = e.k + (v >> 2) * e.size;
              const std::uint64_t key   = grid.vertex_key(cell.block, i, j, k);
              const auto [entry, fresh] = mesh.node.try_emplace(key, mesh.key.size());
              if (fresh)
                {
                  mesh.key.push_back(key);
                  mesh.position.push_back(grid.position(cell.block, i, j, k));
                }
              corners[v] = entry->second;
            }
          mesh.corners.push_back(corners);
        }
    }

    /// Nodes in the middle of an edge or a face of an undivided cell hang on its ends or corners.
    void
    find_hanging(WholeMesh &mesh, const PerBody<SweptGrid> &grids)
    {
      // middles of edges and faces in halves of the cell, the parents by their corner numbers
      static const auto middles = []() {
        std::vector<std::pair<std::array<int, 3>, std::vector<unsigned int>>> all;
        for (int n = 0; n < 27; ++n)
          {
            const std::array<int, 3> place = {n % 3, n / 3 % 3, n / 9};
            const int                odd   = (place[0] == 1) + (place[1] == 1) + (place[2] == 1);
            if (odd != 1 && odd != 2)
              continue;
            std::vector<unsigned int> parents;
            for (unsigned int v = 0; v < 8; ++v)
              {
                bool is = true;
                for (unsigned int d = 0; d < 3; ++d)
                  is = is && (place[d] == 1 || place[d] == 2 * static_cast<int>(v >> d & 1));
                if (is)
                  parents.push_back(v);
              }
            all.emplace_back(place, parents);
          }
        return all;
      }();
      for (std::size_t c = 0; c < mesh.cells.size(); ++c)
        {
          const CellPlace &cell = mesh.cells[c];
          const SweptGrid &grid = grids[cell.body];
          const Extent     e    = extent(cell, grid.levels());
          const int        half = e.size / 2;
          if (half == 0)
            continue;
          for (const auto &[place, parents] : middles)
            {
              const auto found = mesh.node.find(grid.vertex_key(
                cell.block, e.i + place[0] * half, e.j + place[1] * half, e.k + place[2] * half));
              if (found == mesh.node.end())
                continue;
              Parents &of_node = mesh.hanging[found->second];
              if (of_node.empty())
                for (const unsigned int v : parents)
                  of_node.emplace_back(mesh.corners[c][v], 1. / parents.size());
            }
        }
    }

    /// Replaces parents that hang themselves by theirs.
    const Parents &
    resolve(WholeMesh &mesh, const std::uint32_t node)
    {
      Parents &parents = mesh.hanging.at(node);
      bool     chained = false;
      for (const auto &parent : parents)
        chained = chained || mesh.hanging.count(parent.first) > 0;
      if (chained)
        {
          Parents own;
          for (const auto &[parent, weight] : parents)
            if (mesh.hanging.count(parent) == 0)
              own.emplace_back(parent, weight);
            else
              for (const auto &[beyond, share] : resolve(mesh, parent))
                own.emplace_back(beyond, weight * share);
          parents.swap(own);
        }
      std::sort(parents.begin(), parents.end());
      std::size_t last = 0;
      for (std::size_t p = 1; p < parents.size(); ++p)
        if (parents[p].first == parents[last].first)
          parents[last].second += parents[p].second;
        else
          parents[++last] = parents[p];
      parents.resize(last + 1);
      return parents;
    }

    WholeMesh
    whole_mesh(const CellTree &tree, const PerBody<SweptGrid> &grids, const PerBody<int> &first_column)
    {
      WholeMesh mesh;
      mesh.cells = tree.leaves(first_column);
      number_nodes(mesh, grids);
      find_hanging(mesh, grids);
      for (auto &entry : mesh.hanging)
        resolve(mesh, entry.first);
      return mesh;
    }

    /// Cells [begin, end) of a rank.
    std::pair<std::size_t, std::size_t>
    cells_of_rank(const std::size_t n_cells, const int rank, const int size)
    {
      return {n_cells * rank / size, n_cells * (rank + 1) / size};
    }

    /// Marks the nodes that a rank holds: the corners of its cells and the parents of those that hang.
    std::vector<char>
    held_nodes(const WholeMesh &mesh, const int rank, const int size)
    {
      std::vector<char> held(mesh.key.size(), 0);
      const auto [begin, end] = cells_of_rank(mesh.cells.size(), rank, size);
      for (std::size_t c = begin; c < end; ++c)
        for (const std::uint32_t node : mesh.corners[c])
          if (held[node] == 0)
            {
              held[node] = 1;
              if (const auto found = mesh.hanging.find(node); found != mesh.hanging.end())
                for (const auto &parent : found->second)
                  held[parent.first] = std::max<char>(held[parent.first], 2);
            }
      return held;
    }

    void
    add_faces(LocalMesh                         &local,
              const CellPlace                   &cell,
              const SweptGrid                   &grid,
              const std::array<unsigned int, 8> &nodes)
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
              face.nodes[v] = nodes[corner[f][v]];
            face.cell   = local.cells.size() - 1;
            face.mark   = mark;
            face.body   = cell.body;
            face.finest = cell.level == grid.levels();
            face.strip  = grid.in_strip(cell.block);
            local.faces.push_back(face);
          }
    }

    void
    add_hanging(LocalMesh &local, const WholeMesh &whole, std::vector<unsigned int> &number)
    {
      local.hanging_begin.push_back(0);
      const std::size_t n_vertices = local.global_node.size();
      for (unsigned int n = 0; n < n_vertices; ++n)
        if (const auto found = whole.hanging.find(local.global_node[n]); found != whole.hanging.end())
          {
            local.hanging.push_back(n);
            for (const auto &[parent, weight] : found->second)
              {
                if (number[parent] == ~0u)
                  {
                    number[parent] = local.global_node.size();
                    local.global_node.push_back(parent);
                  }
                local.parents.push_back(number[parent]);
                local.weights.push_back(weight);
              }
            local.hanging_begin.push_back(local.parents.size());
          }
    }

    /// Positions of the rank's nodes, those that hang at the mean of their parents.
    void
    place_nodes(LocalMesh &local, const WholeMesh &whole)
    {
      local.reference.assign(4 * local.n_nodes(), 0.);
      for (unsigned int n = 0; n < local.n_nodes(); ++n)
        {
          const std::uint32_t node = local.global_node[n];
          std::copy_n(whole.position[node].begin(), 3, &local.reference[4 * n]);
          local.node_key.push_back(whole.key[node]);
          local.node_body.push_back(static_cast<Body>(whole.key[node] >> 62));
        }
      for (std::size_t k = 0; k < local.hanging.size(); ++k)
        {
          Vector3 mean{};
          for (unsigned int p = local.hanging_begin[k]; p < local.hanging_begin[k + 1]; ++p)
            wheelrail::add(mean, local.weights[p], whole.position[local.global_node[local.parents[p]]]);
          std::copy(mean.begin(), mean.end(), &local.reference[4 * local.hanging[k]]);
        }
    }

    /// The nodes that other ranks hold too, and which ones this rank owns.
    void
    add_neighbours(LocalMesh                       &local,
                   const WholeMesh                 &whole,
                   const std::vector<unsigned int> &number,
                   const int                        rank,
                   const int                        size)
    {
      local.owned.assign(local.n_nodes(), 1);
      for (int other = 0; other < size; ++other)
        if (other != rank)
          {
            const std::vector<char> held = held_nodes(whole, other, size);
            Neighbour               neighbour{other, {}};
            for (std::uint32_t node = 0; node < held.size(); ++node)
              if (held[node] && number[node] != ~0u)
                {
                  neighbour.nodes.push_back(number[node]);
                  if (other < rank)
                    local.owned[number[node]] = 0;
                }
            if (!neighbour.nodes.empty())
              local.neighbours.push_back(std::move(neighbour));
          }
    }
  } // namespace


  SweptMesh::SweptMesh(SweepPlan plan)
    : plan_(std::move(plan))
    , grids_{SweptGrid(plan_, Body::rail), SweptGrid(plan_, Body::wheel)}
  {
  }


  LocalMesh
  SweptMesh::make(const PerBody<FineZone> &zones,
                  const PerBody<int>      &first_column,
                  MPI_Comm                 communicator) const
  {
    int rank, size;
    MPI_Comm_rank(communicator, &rank);
    MPI_Comm_size(communicator, &size);
    const WholeMesh whole = whole_mesh(CellTree(plan_, grids_, zones), grids_, first_column);

    LocalMesh                 local;
    std::vector<unsigned int> number(whole.key.size(), ~0u);
    const auto [begin, end] = cells_of_rank(whole.cells.size(), rank, size);
    for (std::size_t c = begin; c < end; ++c)
      {
        std::array<unsigned int, 8> nodes;
        for (unsigned int v = 0; v < 8; ++v)
          {
            const std::uint32_t node = whole.corners[c][v];
            if (number[node] == ~0u)
              {
                number[node] = local.global_node.size();
                local.global_node.push_back(node);
              }
            nodes[v] = number[node];
          }
        const CellPlace &cell = whole.cells[c];
        local.cells.push_back(nodes);
        local.cell_key.push_back(cell.key());
        local.cell_number.push_back(static_cast<std::uint32_t>(c));
        local.cell_body.push_back(cell.body);
        local.cell_level.push_back(cell.level);
        add_faces(local, cell, grids_[cell.body], nodes);
      }
    add_hanging(local, whole, number);
    local.node_number = local.global_node;
    place_nodes(local, whole);
    add_neighbours(local, whole, number, rank, size);
    return local;
  }
} // namespace wheelrail
