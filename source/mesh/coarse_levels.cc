#include <wheelrail/base/gather_all.h>
#include <wheelrail/mesh/coarse_levels.h>
#include <wheelrail/mesh/forest.h>
#include <wheelrail/mesh/mesh_topology.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <stdexcept>
#include <unordered_map>
#include <utility>

namespace wheelrail
{
  namespace
  {
    /// The cells of a level, each with the first of the finest mesh's cells inside.
    struct LevelCells
    {
      std::vector<CellPlace>   cells;
      std::vector<std::size_t> first; ///< ascending, as the cells inside follow one another

      LevelCells(const std::vector<CellPlace> &finest, const unsigned char level)
      {
        for (std::size_t c = 0; c < finest.size(); ++c)
          {
            const CellPlace cell = finest[c].level > level ? finest[c].ancestor(level) : finest[c];
            if (cells.empty() || cell.key() != cells.back().key())
              {
                cells.push_back(cell);
                first.push_back(c);
              }
          }
      }

      /// A rank works on the cells of which it has the first one inside, and holds the nodes of all of which
      /// it has any.
      RankCells
      share(const CellStretch &finest) const
      {
        const auto from = [&](const std::size_t c) {
          return static_cast<std::size_t>(std::lower_bound(first.begin(), first.end(), c) - first.begin());
        };
        const CellStretch own  = {from(finest.begin), from(finest.end)};
        CellStretch       held = own;
        if (finest.begin < finest.end && (own.begin == first.size() || first[own.begin] != finest.begin))
          --held.begin;
        return {held, own};
      }
    };

    /// Local number of each node by its key.
    using Numbers = std::unordered_map<std::uint64_t, unsigned int>;

    Numbers
    numbers_by_key(const LocalMesh &mesh)
    {
      Numbers numbers(mesh.n_nodes());
      for (unsigned int n = 0; n < mesh.n_nodes(); ++n)
        numbers.emplace(mesh.node_key[n], n);
      return numbers;
    }

    using Row = std::vector<std::pair<unsigned int, double>>;

    /// What the nodes of the finer mesh take from the cells of a level that are divided there.
    std::vector<Row>
    interpolation_rows(const LevelCells  &level,
                       const CellStretch &held,
                       const Numbers     &coarse,
                       const LocalMesh   &finer,
                       const Forest      &forest)
    {
      const Numbers    fine = numbers_by_key(finer);
      std::vector<Row> rows(finer.n_nodes());
      for (std::size_t c = held.begin; c < held.end; ++c)
        {
          const CellPlace &cell = level.cells[c];
          if (forest.cells()[level.first[c]].level == cell.level)
            continue; // not divided
          const SweptGrid            &grid = forest.grid(cell.body);
          std::array<unsigned int, 8> corner;
          for (const HalfPlace &half : half_places())
            if (half.parents.size() == 1)
              corner[half.parents[0]] = coarse.at(half_place_key(cell, half.place, grid));
          for (const HalfPlace &half : half_places())
            if (const auto node = fine.find(half_place_key(cell, half.place, grid));
                node != fine.end() && rows[node->second].empty())
              for (const unsigned int v : half.parents)
                rows[node->second].emplace_back(corner[v], 1. / half.parents.size());
        }
      for (const auto &[key, n] : fine)
        if (const auto same = coarse.find(key); same != coarse.end())
          rows[n] = {{same->second, 1.}};
      return rows;
    }

    /// Interpolation from a level to the next finer mesh.
    void
    make_interpolation(CoarseLevel       &level,
                       const LevelCells  &cells,
                       const CellStretch &held,
                       const LocalMesh   &finer,
                       const Forest      &forest)
    {
      std::vector<Row>  rows = interpolation_rows(cells, held, numbers_by_key(level.mesh), finer, forest);
      std::vector<bool> hangs(finer.n_nodes());
      for (const unsigned int n : finer.hanging)
        hangs[n] = true;
      level.begin.push_back(0);
      for (unsigned int n = 0; n < rows.size(); ++n)
        {
          if (rows[n].empty() && !hangs[n])
            throw std::logic_error("a node is not reached from the coarser level");
          if (!hangs[n])
            for (const auto &[node, weight] : rows[n])
              {
                level.nodes.push_back(node);
                level.weights.push_back(weight);
              }
          level.begin.push_back(level.nodes.size());
        }
    }

    /// Numbers the nodes anew over all ranks, those of a rank's own one after the other.
    void
    number_nodes(LocalMesh &mesh, MPI_Comm communicator)
    {
      std::uint32_t own = 0, first = 0;
      for (const auto owned : mesh.owned)
        own += owned;
      MPI_Exscan(&own, &first, 1, MPI_UINT32_T, MPI_SUM, communicator);
      int rank;
      MPI_Comm_rank(communicator, &rank);
      struct Number
      {
        std::uint32_t before, now;
      };
      std::unordered_map<std::uint32_t, unsigned int> local;
      std::vector<Number>                             shared; // what others must be told
      for (const Neighbour &neighbour : mesh.neighbours)
        for (const unsigned int n : neighbour.nodes)
          local.try_emplace(mesh.global_node[n], n);
      std::uint32_t next = rank == 0 ? 0 : first;
      for (unsigned int n = 0; n < mesh.n_nodes(); ++n)
        if (mesh.owned[n])
          {
            if (local.count(mesh.global_node[n]) != 0)
              shared.push_back({mesh.global_node[n], next});
            mesh.global_node[n] = next++;
          }
      for (const Number &number : gather_all(shared, communicator))
        if (const auto node = local.find(number.before); node != local.end())
          mesh.global_node[node->second] = number.now;
    }
  } // namespace


  std::vector<CoarseLevel>
  coarse_levels(const Forest &forest, const LocalMesh &finest)
  {
    int rank, size;
    MPI_Comm_rank(forest.communicator(), &rank);
    MPI_Comm_size(forest.communicator(), &size);
    unsigned char deepest = 0;
    for (const CellPlace &cell : forest.cells())
      deepest = std::max(deepest, cell.level);
    std::vector<CoarseLevel> levels(deepest);
    const LocalMesh         *finer = &finest;
    for (std::size_t k = 0; k < levels.size(); ++k)
      {
        const LevelCells       cells(forest.cells(), static_cast<unsigned char>(deepest - 1 - k));
        const MeshTopology     topology(cells.cells, forest.grids());
        std::vector<RankCells> shares;
        for (int r = 0; r < size; ++r)
          shares.push_back(cells.share(share_of_rank(forest.cells().size(), r, size)));
        levels[k].mesh = rank_mesh(topology, shares, rank);
        make_interpolation(levels[k], cells, shares[rank].held, *finer, forest);
        finer = &levels[k].mesh;
      }
    for (auto &level : levels)
      number_nodes(level.mesh, forest.communicator());
    return levels;
  }
} // namespace wheelrail
