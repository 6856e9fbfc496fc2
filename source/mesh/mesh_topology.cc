#include <wheelrail/mesh/mesh_topology.h>

#include <algorithm>

namespace wheelrail
{
  namespace
  {
    void
    number_nodes(MeshTopology &mesh, const PerBody<SweptGrid> &grids)
    {
      mesh.node.reserve(2 * mesh.cells.size());
      mesh.corners.reserve(mesh.cells.size());
      for (const CellPlace &cell : mesh.cells)
        {
          const SweptGrid      &grid = grids[cell.body];
          const int             size = 1 << (grid.levels() - cell.level);
          MeshTopology::Corners corners;
          for (unsigned int v = 0; v < 8; ++v)
            {
              const int i = (cell.i + int(v & 1)) * size, j = (cell.j + int(v >> 1 & 1)) * size,
                        k               = (cell.k + int(v >> 2)) * size;
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

    void
    find_hanging(MeshTopology &mesh, const PerBody<SweptGrid> &grids)
    {
      for (std::size_t c = 0; c < mesh.cells.size(); ++c)
        {
          const CellPlace &cell = mesh.cells[c];
          const SweptGrid &grid = grids[cell.body];
          if (cell.level == grid.levels())
            continue;
          for (const HalfPlace &half : half_places())
            {
              if (half.parents.size() == 1 || half.parents.size() == 8)
                continue;
              const auto found = mesh.node.find(half_place_key(cell, half.place, grid));
              if (found == mesh.node.end())
                continue;
              MeshTopology::Parents &of_node = mesh.hanging[found->second];
              if (of_node.empty())
                for (const unsigned int v : half.parents)
                  of_node.emplace_back(mesh.corners[c][v], 1. / half.parents.size());
            }
        }
    }

    /// Replaces parents that hang themselves by theirs.
    const MeshTopology::Parents &
    resolve(MeshTopology &mesh, const std::uint32_t node)
    {
      MeshTopology::Parents &parents = mesh.hanging.at(node);
      bool                   chained = false;
      for (const auto &parent : parents)
        chained = chained || mesh.hanging.count(parent.first) > 0;
      if (chained)
        {
          MeshTopology::Parents own;
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
  } // namespace


  MeshTopology::MeshTopology(const std::vector<CellPlace> &all_cells, const PerBody<SweptGrid> &grids)
    : cells(all_cells)
  {
    number_nodes(*this, grids);
    find_hanging(*this, grids);
    for (auto &entry : hanging)
      resolve(*this, entry.first);
  }


  const std::vector<HalfPlace> &
  half_places()
  {
    static const auto all = []() {
      std::vector<HalfPlace> places;
      for (int n = 0; n < 27; ++n)
        {
          HalfPlace half{{n % 3, n / 3 % 3, n / 9}, {}};
          for (unsigned int v = 0; v < 8; ++v)
            {
              bool is = true;
              for (unsigned int d = 0; d < 3; ++d)
                is = is && (half.place[d] == 1 || half.place[d] == 2 * static_cast<int>(v >> d & 1));
              if (is)
                half.parents.push_back(v);
            }
          places.push_back(half);
        }
      return places;
    }();
    return all;
  }


  std::uint64_t
  half_place_key(const CellPlace &cell, const std::array<int, 3> &place, const SweptGrid &grid)
  {
    const int half = 1 << (grid.levels() - cell.level - 1);
    return grid.vertex_key(cell.block,
                           (2 * cell.i + place[0]) * half,
                           (2 * cell.j + place[1]) * half,
                           (2 * cell.k + place[2]) * half);
  }


  CellStretch
  share_of_rank(const std::size_t n, const int rank, const int size)
  {
    return {n * rank / size, n * (rank + 1) / size};
  }
} // namespace wheelrail
