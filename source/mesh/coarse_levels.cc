#include <deal.II/base/mpi.h>
#include <deal.II/distributed/tria.h>

#include <wheelrail/mesh/coarse_levels.h>
#include <wheelrail/mesh/discretization.h>
#include <wheelrail/mesh/fetch_rows.h>
#include <wheelrail/mesh/shared_nodes.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <stdexcept>
#include <unordered_map>
#include <utility>

namespace wheelrail
{
  namespace
  {
    constexpr unsigned int no_node = ~0u;
    using Cell                     = Discretization::Cell;
    using Iterator                 = Discretization::Triangulation::cell_iterator;

    /// Which of its parent's parts a cell is.
    unsigned int
    child_number(const CellPlace &cell)
    {
      return (cell.i & 1) | (cell.j & 1) << 1 | (cell.k & 1) << 2;
    }

    /// The vertices of a cell's parent in whose middle vertex v of the cell lies.
    std::vector<unsigned int>
    parents_of_vertex(const unsigned int child, const unsigned int v)
    {
      std::vector<unsigned int> parents;
      for (unsigned int p = 0; p < 8; ++p)
        if (((p ^ child) & ~(v ^ child)) == 0)
          parents.push_back(p);
      return parents;
    }

    // --- vertices that hang ---

    /// Which vertices of the triangulation hang on all levels that have them: those in the middle of an edge
    /// or a face of a cell that is not divided. Those of the rank's own cells are certain; other ranks tell
    /// of those of parents that have parts there. Collective.
    class HangingVertices
    {
    public:
      explicit HangingVertices(const Discretization &discretization)
        : triangulation_(discretization.triangulation())
        , hangs_(triangulation_.n_vertices(), 0)
      {
        for (const auto &cell : triangulation_.active_cell_iterators())
          if (!cell->is_artificial())
            {
              for (unsigned int e = 0; e < 12; ++e)
                if (const auto line = cell->line(e); line->has_children())
                  hangs_[line->child(0)->vertex_index(1)] = 1;
              for (unsigned int f = 0; f < 6; ++f)
                if (const auto face = cell->face(f); face->has_children())
                  hangs_[face->child(0)->vertex_index(3)] = 1;
            }
        if (dealii::Utilities::MPI::n_mpi_processes(discretization.communicator()) > 1)
          exchange_parents(discretization);
      }

      bool
      operator[](const unsigned int vertex) const
      {
        return hangs_[vertex] != 0;
      }

    private:
      /// Parents that have parts on several ranks hold the first or the last cell of each of them.
      void
      exchange_parents(const Discretization &discretization)
      {
        struct Parent
        {
          std::uint64_t                key;
          std::array<unsigned char, 8> hangs;
        };
        std::map<std::uint64_t, Iterator> here;
        std::vector<std::uint64_t>        keys;
        std::vector<Parent>               own;
        const auto                       &cells = discretization.own_cells();
        if (!cells.empty())
          for (const Cell *end : {&cells.front(), &cells.back()})
            {
              Iterator  cell(&triangulation_, end->level, end->index);
              CellPlace place = end->place;
              while (place.level > 0)
                {
                  cell  = cell->parent();
                  place = place.ancestor(place.level - 1);
                  here.emplace(place.key(), cell);
                }
            }
        for (const auto &[key, cell] : here)
          {
            keys.push_back(key);
            Parent &parent = own.emplace_back(Parent{key, {}});
            for (unsigned int v = 0; v < 8; ++v)
              parent.hangs[v] = hangs_[cell->vertex_index(v)];
          }
        for (const Parent &parent : fetch_rows(keys, own, keys, discretization.communicator()))
          for (unsigned int v = 0; v < 8; ++v)
            if (parent.hangs[v])
              hangs_[here.at(parent.key)->vertex_index(v)] = 1;
      }

      const Discretization::Triangulation &triangulation_;
      std::vector<unsigned char>           hangs_;
    };

    // --- one level ---

    /// The cells of a level that have a part among the rank's own, and its nodes by the triangulation's
    /// vertices.
    struct Level
    {
      std::vector<Cell> cells;
      bool              first_is_own = true; ///< another rank may have the first part of the first cell
      std::vector<unsigned int> vertex;      ///< of each node
      std::vector<unsigned int> node;        ///< of each vertex of the triangulation, or none
    };

    /// The cells with those of the finest level joined.
    void
    join(Level &level, const unsigned char to, const Discretization::Triangulation &triangulation)
    {
      std::vector<Cell> joined;
      for (const Cell &cell : level.cells)
        {
          if (cell.level <= to)
            {
              joined.push_back(cell);
              continue;
            }
          if (joined.empty() && child_number(cell.place) != 0)
            level.first_is_own = false;
          const int parent = Iterator(&triangulation, cell.level, cell.index)->parent_index();
          if (joined.empty() || joined.back().level != to || joined.back().index != parent)
            joined.push_back({to, parent, cell.place.ancestor(to)});
        }
      level.cells.swap(joined);
    }

    /// Numbers the nodes of a level's cells and fills the arrays of its mesh.
    class LevelMeshMaker
    {
    public:
      LevelMeshMaker(const Discretization &discretization, const HangingVertices &hangs, Level &level)
        : discretization_(discretization)
        , triangulation_(discretization.triangulation())
        , hangs_(hangs)
        , level_(level)
      {
        level_.vertex.clear();
        level_.node.assign(triangulation_.n_vertices(), no_node);
      }

      LocalMesh
      make()
      {
        struct Use
        {
          const Cell  *cell;
          unsigned int v;
        };
        std::vector<Use> hanging;
        for (std::size_t c = 0; c < level_.cells.size(); ++c)
          {
            const Cell                 &cell = level_.cells[c];
            const Iterator              here(&triangulation_, cell.level, cell.index);
            std::array<unsigned int, 8> corners;
            for (unsigned int v = 0; v < 8; ++v)
              {
                const unsigned int vertex = here->vertex_index(v);
                if (level_.node[vertex] == no_node && hangs_[vertex])
                  hanging.push_back({&cell, v});
                corners[v] = node(vertex, cell.place, v);
              }
            if (c == 0 && !level_.first_is_own)
              continue;
            mesh_.cells.push_back(corners);
            mesh_.cell_body.push_back(cell.place.body);
            mesh_.cell_level.push_back(cell.place.level);
          }
        mesh_.hanging_begin.push_back(0);
        for (const Use &use : hanging)
          add_hanging(*use.cell, use.v);
        return std::move(mesh_);
      }

    private:
      unsigned int
      node(const unsigned int vertex, const CellPlace &cell, const unsigned int v)
      {
        unsigned int &n = level_.node[vertex];
        if (n == no_node)
          {
            const SweptGrid &grid = discretization_.grid(cell.body);
            n                     = level_.vertex.size();
            level_.vertex.push_back(vertex);
            mesh_.global_node.push_back(n);
            mesh_.node_key.push_back(grid.vertex_key(cell, v));
            mesh_.node_body.push_back(cell.body);
            const Vector3 X = grid.position(cell, v);
            mesh_.reference.insert(mesh_.reference.end(), {X[0], X[1], X[2], 0.});
          }
        return n;
      }

      void
      add_hanging(const Cell &cell, const unsigned int v)
      {
        const Iterator  here   = Iterator(&triangulation_, cell.level, cell.index);
        const auto      parent = here->parent();
        const CellPlace place  = cell.place.ancestor(cell.place.level - 1);
        const auto      of_v   = parents_of_vertex(child_number(cell.place), v);
        const double    weight = 1. / of_v.size();
        Vector3         mean{};
        for (const unsigned int p : of_v)
          {
            mesh_.parents.push_back(node(parent->vertex_index(p), place, p));
            mesh_.weights.push_back(weight);
            add(mean, weight, discretization_.grid(place.body).position(place, p));
          }
        const unsigned int n = level_.node[here->vertex_index(v)];
        std::copy(mean.begin(), mean.end(), &mesh_.reference[4 * n]);
        mesh_.hanging.push_back(n);
        mesh_.hanging_begin.push_back(mesh_.parents.size());
      }

      const Discretization                &discretization_;
      const Discretization::Triangulation &triangulation_;
      const HangingVertices               &hangs_;
      Level                               &level_;
      LocalMesh                            mesh_;
    };

    /// Takes new numbers of the nodes.
    void
    number(Level &level, const std::vector<unsigned int> &to)
    {
      const std::vector<unsigned int> vertex = level.vertex;
      for (std::size_t n = 0; n < to.size(); ++n)
        {
          level.vertex[to[n]]   = vertex[n];
          level.node[vertex[n]] = to[n];
        }
    }

    // --- between levels ---

    /// The finest mesh as a level: its nodes by vertices, also those that no own cell has, which are vertices
    /// of parents of own cells.
    Level
    finest_level(const Discretization &discretization, const LocalMesh &finest)
    {
      const auto &triangulation = discretization.triangulation();
      Level       level;
      level.cells = discretization.own_cells();
      level.vertex.assign(finest.n_nodes(), no_node);
      level.node.assign(triangulation.n_vertices(), no_node);
      const auto tell = [&](const unsigned int vertex, const unsigned int n) {
        level.node[vertex] = n;
        level.vertex[n]    = vertex;
      };
      for (std::size_t c = 0; c < level.cells.size(); ++c)
        {
          const Iterator cell(&triangulation, level.cells[c].level, level.cells[c].index);
          for (unsigned int v = 0; v < 8; ++v)
            tell(cell->vertex_index(v), finest.cells[c][v]);
        }
      std::unordered_map<std::uint64_t, unsigned int> foreign;
      for (unsigned int n = 0; n < finest.n_nodes(); ++n)
        if (level.vertex[n] == no_node)
          foreign.emplace(finest.node_key[n], n);
      for (const Cell &cell : level.cells)
        if (cell.level > 0 && !foreign.empty())
          {
            const auto      parent = Iterator(&triangulation, cell.level, cell.index)->parent();
            const CellPlace place  = cell.place.ancestor(cell.place.level - 1);
            for (unsigned int v = 0; v < 8; ++v)
              if (level.node[parent->vertex_index(v)] == no_node)
                if (const auto n = foreign.find(discretization.grid(place.body).vertex_key(place, v));
                    n != foreign.end())
                  tell(parent->vertex_index(v), n->second);
          }
      return level;
    }

    /// Interpolation from a level to the next finer mesh.
    void
    make_interpolation(CoarseLevel                         &coarse,
                       const Level                         &level,
                       const Level                         &finer,
                       const LocalMesh                     &finer_mesh,
                       const Discretization::Triangulation &triangulation)
    {
      struct Source
      {
        const Cell  *cell = nullptr;
        unsigned int child, v;
      };
      std::vector<Source> source(finer.vertex.size());
      for (const Cell &cell : level.cells)
        if (const Iterator here(&triangulation, cell.level, cell.index); here->has_children())
          for (unsigned int c = 0; c < 8; ++c)
            for (unsigned int v = 0; v < 8; ++v)
              if (const unsigned int n = finer.node[here->child(c)->vertex_index(v)]; n != no_node)
                source[n] = {&cell, c, v};
      std::vector<bool> hangs(finer.vertex.size());
      for (const unsigned int n : finer_mesh.hanging)
        hangs[n] = true;
      coarse.begin.push_back(0);
      for (unsigned int n = 0; n < source.size(); ++n)
        {
          const auto take = [&](const unsigned int node, const double weight) {
            coarse.nodes.push_back(node);
            coarse.weights.push_back(weight);
          };
          const unsigned int same = finer.vertex[n] == no_node ? no_node : level.node[finer.vertex[n]];
          if (hangs[n])
            ;
          else if (same != no_node)
            take(same, 1);
          else if (const Cell *cell = source[n].cell)
            {
              const Iterator here(&triangulation, cell->level, cell->index);
              const auto     parents = parents_of_vertex(source[n].child, source[n].v);
              for (const unsigned int p : parents)
                take(level.node[here->vertex_index(p)], 1. / parents.size());
            }
          else
            throw std::logic_error("a node is not reached from the coarser level");
          coarse.begin.push_back(coarse.nodes.size());
        }
    }
  } // namespace


  std::vector<CoarseLevel>
  coarse_levels(const Discretization &discretization, const LocalMesh &finest)
  {
    const auto               communicator  = discretization.communicator();
    const auto              &triangulation = discretization.triangulation();
    const HangingVertices    hangs(discretization);
    Level                    finer   = finest_level(discretization, finest);
    const unsigned int       deepest = triangulation.n_global_levels() - 1;
    std::vector<CoarseLevel> levels(deepest); // which later levels point to
    const LocalMesh         *finer_mesh = &finest;
    for (std::size_t k = 0; k < levels.size(); ++k)
      {
        Level level;
        level.cells        = finer.cells;
        level.first_is_own = finer.first_is_own;
        join(level, static_cast<unsigned char>(deepest - 1 - k), triangulation);
        levels[k].mesh = LevelMeshMaker(discretization, hangs, level).make();
        number(level, number_nodes(levels[k].mesh, communicator));
        make_interpolation(levels[k], level, finer, *finer_mesh, triangulation);
        finer      = std::move(level);
        finer_mesh = &levels[k].mesh;
      }
    return levels;
  }
} // namespace wheelrail
