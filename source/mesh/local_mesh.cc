#include <deal.II/base/index_set.h>
#include <deal.II/distributed/tria.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/lac/affine_constraints.h>

#include <wheelrail/mesh/discretization.h>
#include <wheelrail/mesh/shared_nodes.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

namespace wheelrail
{
  namespace
  {
    constexpr unsigned int none = ~0u;

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

    /// Fills a rank's arrays from the unknowns of a discretization.
    class LocalMeshMaker
    {
    public:
      LocalMeshMaker(const Discretization &discretization, const dealii::IndexSet &relevant)
        : discretization_(discretization)
        , relevant_(relevant)
        , of_dof_(relevant.n_elements(), none)
      {
      }

      LocalMesh
      make()
      {
        add_cells();
        n_vertices_ = local_.n_nodes();
        add_foreign_parents();
        add_hanging();
        return std::move(local_);
      }

    private:
      using Iterator = Discretization::Dofs::cell_iterator;

      unsigned int &
      number(const dealii::types::global_dof_index dof)
      {
        return of_dof_[relevant_.index_within_set(dof)];
      }

      void
      add_node(const dealii::types::global_dof_index dof, const CellPlace &cell, const unsigned int v)
      {
        const SweptGrid &grid = discretization_.grid(cell.body);
        number(dof)           = local_.global_node.size();
        local_.global_node.push_back(dof);
        local_.node_key.push_back(grid.vertex_key(cell, v));
        local_.node_body.push_back(cell.body);
        const Vector3 X = grid.position(cell, v);
        local_.reference.insert(local_.reference.end(), {X[0], X[1], X[2], 0.});
      }

      void
      add_cells()
      {
        for (const Discretization::Cell &cell : discretization_.own_cells())
          {
            const Iterator here(
              &discretization_.triangulation(), cell.level, cell.index, &discretization_.dofs());
            std::array<unsigned int, 8> corners;
            for (unsigned int v = 0; v < 8; ++v)
              {
                const auto dof = here->vertex_dof_index(v, 0);
                if (number(dof) == none)
                  add_node(dof, cell.place, v);
                corners[v] = number(dof);
              }
            local_.cells.push_back(corners);
            local_.cell_body.push_back(cell.place.body);
            local_.cell_level.push_back(cell.place.level);
            local_.cell_key.push_back(cell.place.key());
            add_faces(local_, local_.cells.size() - 1, cell.place, discretization_.grid(cell.place.body));
          }
      }

      /// Parents that no cell of this rank has; cells beside them have.
      void
      add_foreign_parents()
      {
        std::vector<dealii::types::global_dof_index> wanted;
        for (const std::uint32_t dof : local_.global_node)
          if (const auto *line = discretization_.hanging().get_constraint_entries(dof))
            for (const auto &parent : *line)
              if (number(parent.first) == none)
                wanted.push_back(parent.first);
        if (wanted.empty())
          return;
        std::sort(wanted.begin(), wanted.end());
        struct Vertex
        {
          std::uint64_t                   key;
          dealii::types::global_dof_index dof;
          CellPlace                       cell;
          unsigned int                    v;
        };
        std::vector<Vertex> found;
        for (const auto &cell : discretization_.dofs().active_cell_iterators())
          if (cell->is_ghost())
            for (unsigned int v = 0; v < 8; ++v)
              if (const auto dof = cell->vertex_dof_index(v, 0);
                  std::binary_search(wanted.begin(), wanted.end(), dof))
                {
                  const CellPlace place = discretization_.place(*cell);
                  found.push_back({discretization_.grid(place.body).vertex_key(place, v), dof, place, v});
                }
        // in an order that does not depend on the triangulation's
        std::sort(found.begin(), found.end(), [](const Vertex &a, const Vertex &b) { return a.key < b.key; });
        for (const Vertex &vertex : found)
          if (number(vertex.dof) == none)
            add_node(vertex.dof, vertex.cell, vertex.v);
      }

      void
      add_hanging()
      {
        const AlignedVector<double> exact = local_.reference;
        local_.hanging_begin.push_back(0);
        std::vector<std::pair<unsigned int, double>> parents;
        for (unsigned int n = 0; n < n_vertices_; ++n)
          if (const auto *line = discretization_.hanging().get_constraint_entries(local_.global_node[n]))
            {
              parents.clear();
              for (const auto &[dof, weight] : *line)
                parents.emplace_back(number(dof), weight);
              std::sort(parents.begin(), parents.end());
              Vector3 mean{};
              for (const auto &[parent, weight] : parents)
                {
                  local_.parents.push_back(parent);
                  local_.weights.push_back(weight);
                  add(mean, weight, Vector3{exact[4 * parent], exact[4 * parent + 1], exact[4 * parent + 2]});
                }
              std::copy(mean.begin(), mean.end(), &local_.reference[4 * n]);
              local_.hanging.push_back(n);
              local_.hanging_begin.push_back(local_.parents.size());
            }
      }

      const Discretization     &discretization_;
      const dealii::IndexSet   &relevant_;
      std::vector<unsigned int> of_dof_; ///< local number of a relevant unknown
      LocalMesh                 local_;
      std::size_t               n_vertices_ = 0; ///< nodes of own cells
    };
  } // namespace


  LocalMesh
  Discretization::local_mesh() const
  {
    LocalMesh mesh = LocalMeshMaker(*this, *relevant_).make();
    find_neighbours(mesh, communicator_);
    return mesh;
  }
} // namespace wheelrail
