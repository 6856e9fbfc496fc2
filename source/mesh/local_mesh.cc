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
    using Dof                   = dealii::types::global_dof_index;
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
      explicit LocalMeshMaker(const Discretization &discretization)
        : discretization_(discretization)
        , first_(discretization.dofs().locally_owned_dofs().n_elements() > 0
                   ? discretization.dofs().locally_owned_dofs().nth_index_in_set(0)
                   : 0)
      {
        local_.n_owned = discretization.dofs().n_locally_owned_dofs();
      }

      LocalMesh
      make()
      {
        number_nodes();
        add_cells();
        add_foreign_parents();
        add_hanging();
        return std::move(local_);
      }

    private:
      using Iterator = Discretization::Dofs::cell_iterator;

      /// Own unknowns, all of which are vertices of own cells, then others of own cells, or that those of own
      /// cells hang from.
      void
      number_nodes()
      {
        std::vector<Dof> others;
        const auto       see = [&](const Dof dof) {
          if (dof - first_ >= local_.n_owned)
            others.push_back(dof);
        };
        const auto see_parents = [&](const Dof dof) {
          if (const auto *line = discretization_.hanging().get_constraint_entries(dof))
            for (const auto &parent : *line)
              see(parent.first);
        };
        for (const Discretization::Cell &cell : discretization_.own_cells())
          for (unsigned int v = 0; v < 8; ++v)
            see(iterator(cell)->vertex_dof_index(v, 0));
        for (std::size_t k = 0, n = others.size(); k < n; ++k)
          see_parents(others[k]);
        for (unsigned int n = 0; n < local_.n_owned; ++n)
          see_parents(first_ + n);
        std::sort(others.begin(), others.end());
        others.erase(std::unique(others.begin(), others.end()), others.end());
        for (unsigned int n = 0; n < local_.n_owned; ++n)
          local_.global_node.push_back(first_ + n);
        local_.global_node.insert(local_.global_node.end(), others.begin(), others.end());
        const std::size_t n_nodes = local_.n_nodes();
        local_.node_key.resize(n_nodes, no_key);
        local_.node_body.resize(n_nodes);
        local_.reference.resize(4 * n_nodes, 0.);
      }

      Iterator
      iterator(const Discretization::Cell &cell) const
      {
        return {&discretization_.triangulation(), cell.level, cell.index, &discretization_.dofs()};
      }

      /// Local number of an unknown, or none.
      unsigned int
      number(const Dof dof) const
      {
        if (dof - first_ < local_.n_owned)
          return dof - first_;
        const auto ghosts = local_.global_node.begin() + local_.n_owned;
        const auto found  = std::lower_bound(ghosts, local_.global_node.end(), dof);
        return found != local_.global_node.end() && *found == dof
                 ? static_cast<unsigned int>(found - local_.global_node.begin())
                 : none;
      }

      void
      place_node(const unsigned int n, const CellPlace &cell, const unsigned int v)
      {
        if (local_.node_key[n] != no_key)
          return;
        const SweptGrid &grid = discretization_.grid(cell.body);
        local_.node_key[n]    = grid.vertex_key(cell, v);
        local_.node_body[n]   = cell.body;
        const Vector3 X       = grid.position(cell, v);
        std::copy(X.begin(), X.end(), &local_.reference[4 * n]);
      }

      void
      add_cells()
      {
        for (const Discretization::Cell &cell : discretization_.own_cells())
          {
            const Iterator              here = iterator(cell);
            std::array<unsigned int, 8> corners;
            for (unsigned int v = 0; v < 8; ++v)
              {
                corners[v] = number(here->vertex_dof_index(v, 0));
                place_node(corners[v], cell.place, v);
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
        if (local_.n_nodes() > local_.n_owned)
          for (const auto &cell : discretization_.dofs().active_cell_iterators())
            if (cell->is_ghost())
              for (unsigned int v = 0; v < 8; ++v)
                if (const unsigned int n = number(cell->vertex_dof_index(v, 0));
                    n != none && local_.node_key[n] == no_key)
                  place_node(n, discretization_.place(*cell), v);
      }

      void
      add_hanging()
      {
        const AlignedVector<double> exact = local_.reference;
        local_.hanging_begin.push_back(0);
        std::vector<std::pair<unsigned int, double>> parents;
        for (unsigned int n = 0; n < local_.n_nodes(); ++n)
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

      static constexpr std::uint64_t no_key = ~std::uint64_t(0);

      const Discretization &discretization_;
      const Dof             first_; ///< of the rank's own
      LocalMesh             local_;
    };
  } // namespace


  LocalMesh
  Discretization::local_mesh() const
  {
    LocalMesh mesh = LocalMeshMaker(*this).make();
    share_nodes(mesh, communicator_);
    return mesh;
  }
} // namespace wheelrail
