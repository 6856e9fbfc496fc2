#include <deal.II/dofs/dof_handler.h>
#include <deal.II/grid/tria_accessor.h>
#include <deal.II/grid/tria_iterator.h>

#include <wheelrail/base/gather_all.h>
#include <wheelrail/mesh/ancestor_vertices.h>
#include <wheelrail/mesh/coarse_levels.h>
#include <wheelrail/mesh/forest.h>
#include <wheelrail/mesh/neighbours.h>

#include <array>
#include <cstdint>
#include <stdexcept>
#include <unordered_map>

namespace wheelrail
{
  namespace
  {
    using Cell     = AncestorVertices::Cell;
    using NodeData = AncestorVertices::Node;
    /// Local number of each global node.
    using Numbers = std::unordered_map<std::uint32_t, unsigned int>;

    /// Numbers the nodes of a level as they come and writes their data.
    struct LevelNodes
    {
      LocalMesh &mesh;
      Numbers    local;

      unsigned int
      operator()(const std::uint32_t          global,
                 const std::uint64_t          key,
                 const std::array<double, 3> &X,
                 const Body                   body)
      {
        const auto [entry, fresh] = local.try_emplace(global, mesh.n_nodes());
        if (fresh)
          {
            mesh.global_node.push_back(global);
            mesh.node_key.push_back(key);
            mesh.reference.insert(mesh.reference.end(), {X[0], X[1], X[2], 0.});
            mesh.node_body.push_back(body);
          }
        return entry->second;
      }
    };

    /// Whether the rank works on a cell: it owns the first of the active cells inside.
    bool
    works_on(Cell cell)
    {
      while (cell->has_children())
        cell = cell->child(0);
      return cell->is_locally_owned();
    }

    /// The cells of a level that have a part in the rank's mesh, each once.
    std::vector<Cell>
    cells_of_level(const std::vector<Cell> &active, const int level)
    {
      std::vector<Cell>             cells;
      std::unordered_map<int, bool> known;
      for (Cell cell : active)
        {
          const bool joined = cell->level() > level;
          while (cell->level() > level)
            cell = cell->parent();
          if (!joined || known.try_emplace(cell->index(), true).second)
            cells.push_back(cell);
        }
      return cells;
    }

    Numbers
    make_mesh(const std::vector<Cell> &cells, const AncestorVertices &vertices, LocalMesh &mesh)
    {
      LevelNodes            node{mesh, {}};
      std::vector<NodeData> data;
      for (const Cell &cell : cells)
        {
          const Body                  body = cell->material_id() == 0 ? Body::rail : Body::wheel;
          std::array<unsigned int, 8> nodes;
          for (unsigned int v = 0; v < 8; ++v)
            {
              const NodeData known = vertices.at(cell->vertex_index(v));
              nodes[v]             = node(known.global, known.key, known.reference, known.body);
              if (nodes[v] == data.size())
                data.push_back(known);
            }
          if (!works_on(cell))
            continue;
          mesh.cells.push_back(nodes);
          mesh.cell_body.push_back(body);
          mesh.cell_level.push_back(cell->level());
        }
      // a node that hangs here hangs in the finest mesh, from the same cell
      mesh.hanging_begin.push_back(0);
      for (unsigned int n = 0; n < data.size(); ++n)
        if (data[n].n_parents > 0)
          {
            mesh.hanging.push_back(n);
            for (unsigned int p = 0; p < data[n].n_parents; ++p)
              {
                const auto &parent = data[n].parents[p];
                mesh.parents.push_back(node(parent.global, parent.key, parent.reference, data[n].body));
                mesh.weights.push_back(parent.weight);
              }
            mesh.hanging_begin.push_back(mesh.parents.size());
          }
      return std::move(node.local);
    }

    /// Weights of the vertices of a cell at a vertex of one of its children.
    std::array<double, 8>
    child_weights(const unsigned int child, const unsigned int vertex)
    {
      std::array<double, 8> weight;
      for (unsigned int c = 0; c < 8; ++c)
        {
          weight[c] = 1;
          for (unsigned int k = 0; k < 3; ++k)
            {
              const unsigned int place = (child >> k & 1) + (vertex >> k & 1); // 0, 1, 2 along the cell
              weight[c] *= place == 1 ? 0.5 : place / 2 == (c >> k & 1) ? 1 : 0;
            }
        }
      return weight;
    }

    using Row = std::vector<std::pair<unsigned int, double>>;

    /// Interpolation from the level with `cells` to the next finer mesh.
    void
    make_interpolation(CoarseLevel             &level,
                       const std::vector<Cell> &cells,
                       const Numbers           &coarse,
                       const LocalMesh         &finer,
                       const Numbers           &fine,
                       const int                number,
                       const AncestorVertices  &vertices)
    {
      std::vector<Row> rows(finer.n_nodes());
      for (const Cell &cell : cells)
        if (cell->level() == number && cell->has_children())
          for (unsigned int k = 0; k < 8; ++k)
            for (unsigned int v = 0; v < 8; ++v)
              {
                const unsigned int vertex = cell->child(k)->vertex_index(v);
                if (!vertices.knows(vertex))
                  continue;
                const auto node = fine.find(vertices.at(vertex).global);
                if (node == fine.end() || !rows[node->second].empty())
                  continue;
                const auto weight = child_weights(k, v);
                for (unsigned int c = 0; c < 8; ++c)
                  if (weight[c] > 0)
                    rows[node->second].emplace_back(coarse.at(vertices.at(cell->vertex_index(c)).global),
                                                    weight[c]);
              }
      for (const auto &[global, n] : fine)
        if (const auto same = coarse.find(global); same != coarse.end())
          rows[n] = {{same->second, 1.}};
      for (const unsigned int n : finer.hanging)
        rows[n] = {{0, 0.}};
      for (const Row &row : rows)
        if (row.empty())
          throw std::logic_error("a node is not reached from the coarser level");
      for (const unsigned int n : finer.hanging)
        rows[n].clear();
      level.begin.push_back(0);
      for (const Row &row : rows)
        {
          for (const auto &[node, weight] : row)
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
      Numbers             local;
      std::vector<Number> shared; // what others must be told
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
    const AncestorVertices   vertices(forest, finest);
    const int                n_levels = forest.dofs().get_triangulation().n_global_levels();
    std::vector<CoarseLevel> levels(n_levels - 1);
    const LocalMesh         *finer = &finest;
    Numbers                  fine;
    for (unsigned int n = 0; n < finest.n_nodes(); ++n)
      fine[finest.global_node[n]] = n;
    for (std::size_t k = 0; k < levels.size(); ++k)
      {
        const int  level  = n_levels - 2 - static_cast<int>(k);
        const auto cells  = cells_of_level(vertices.active, level);
        Numbers    coarse = make_mesh(cells, vertices, levels[k].mesh);
        find_neighbours(levels[k].mesh, forest.communicator());
        make_interpolation(levels[k], cells, coarse, *finer, fine, level, vertices);
        finer = &levels[k].mesh;
        fine  = std::move(coarse);
      }
    for (auto &level : levels)
      number_nodes(level.mesh, forest.communicator());
    return levels;
  }
} // namespace wheelrail
