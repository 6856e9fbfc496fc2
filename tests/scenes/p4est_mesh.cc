#include <deal.II/distributed/tria.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/grid/tria.h>
#include <deal.II/lac/affine_constraints.h>

#include <wheelrail/base/gather_all.h>

#include "scenes/p4est_mesh.h"

#include <cstdint>
#include <map>
#include <set>
#include <vector>

using namespace wheelrail;

namespace test
{
  namespace
  {
    /// A hanging node and one of its parents.
    struct Share
    {
      std::uint64_t node, parent;
      double        weight;
    };

    MeshByKeys
    of_all_ranks(const std::vector<std::uint64_t> &cells,
                 const std::vector<std::uint64_t> &nodes,
                 const std::vector<std::uint64_t> &outer,
                 const std::vector<Share>         &shares,
                 MPI_Comm                          communicator)
    {
      const auto all = [&](const std::vector<std::uint64_t> &own) {
        const auto keys = gather_all(own, communicator);
        return std::set<std::uint64_t>(keys.begin(), keys.end());
      };
      MeshByKeys mesh;
      mesh.cells = all(cells);
      mesh.nodes = all(nodes);
      mesh.outer = all(outer);
      std::map<std::uint64_t, std::map<std::uint64_t, double>> parents;
      for (const Share &share : gather_all(shares, communicator))
        parents[share.node][share.parent] = share.weight; // several ranks tell the same
      for (const auto &[node, of_node] : parents)
        mesh.hanging[node] = {of_node.begin(), of_node.end()};
      return mesh;
    }

    class Judge
    {
    public:
      Judge(const Discretization &discretization, const PerBody<FineZone> &zones, MPI_Comm communicator)
        : discretization_(discretization)
        , triangulation_(communicator)
      {
        make_coarse_mesh();
        const RefinementRule rule(discretization.plan(), discretization.grids(), zones);
        for (unsigned int level = 0; level < discretization.plan().levels; ++level)
          {
            for (const auto &cell : triangulation_.active_cell_iterators_on_level(level))
              if (cell->is_locally_owned() && rule.wanted(place(*cell)))
                cell->set_refine_flag();
            triangulation_.execute_coarsening_and_refinement();
          }
      }

      MeshByKeys
      by_keys() const
      {
        const dealii::FE_Q<3> element(1);
        dealii::DoFHandler<3> dofs(triangulation_);
        dealii::IndexSet      relevant;
        dofs.distribute_dofs(element);
        dealii::DoFTools::extract_locally_relevant_dofs(dofs, relevant);
        dealii::AffineConstraints<double> constraints(relevant);
        dealii::DoFTools::make_hanging_node_constraints(dofs, constraints);
        constraints.close();

        std::vector<std::uint64_t>                   cells, nodes, outer;
        std::map<std::uint64_t, std::uint64_t>       key; // of a degree of freedom
        std::vector<std::uint64_t>                   own; // degrees of freedom of own cells
        std::vector<dealii::types::global_dof_index> dof(8);
        for (const auto &cell : dofs.active_cell_iterators())
          if (!cell->is_artificial())
            {
              const CellPlace where = place(*cell);
              cell->get_dof_indices(dof);
              for (unsigned int v = 0; v < 8; ++v)
                key[dof[v]] = vertex_key(where, v);
              if (!cell->is_locally_owned())
                continue;
              cells.push_back(where.key());
              own.insert(own.end(), dof.begin(), dof.end());
              for (unsigned int f = 0; f < 6; ++f)
                for (unsigned int v = 0; v < 8; ++v)
                  if (cell->face(f)->at_boundary() && (v >> (f / 2) & 1) == f % 2)
                    outer.push_back(vertex_key(where, v));
            }
        std::vector<Share> shares;
        for (const std::uint64_t n : own)
          {
            nodes.push_back(key.at(n));
            if (const auto *entries = constraints.get_constraint_entries(n))
              for (const auto &[parent, weight] : *entries)
                shares.push_back({key.at(n), key.at(parent), weight});
          }
        return of_all_ranks(cells, nodes, outer, shares, triangulation_.get_communicator());
      }

    private:
      CellPlace
      coarse_place(const int number) const
      {
        const int n_rail =
          discretization_.grid(Body::rail).n_blocks() * discretization_.grid(Body::rail).n_columns();
        CellPlace cell;
        cell.body   = number < n_rail ? Body::rail : Body::wheel;
        const int n = number - (number < n_rail ? 0 : n_rail);
        cell.block  = n % discretization_.grid(cell.body).n_blocks();
        cell.k      = n / discretization_.grid(cell.body).n_blocks();
        return cell;
      }

      CellPlace
      place(const dealii::CellAccessor<3> &cell) const
      {
        dealii::TriaIterator<dealii::CellAccessor<3>> ancestor(cell);
        while (ancestor->level() > 0)
          ancestor = ancestor->parent();
        CellPlace            place = coarse_place(ancestor->index());
        const dealii::CellId id    = cell.id();
        for (const auto child : id.get_child_indices())
          place = place.child(child);
        return place;
      }

      std::uint64_t
      vertex_key(const CellPlace &cell, const unsigned int v) const
      {
        const int size = 1 << (discretization_.plan().levels - cell.level);
        return discretization_.grid(cell.body).vertex_key(cell.block,
                                                          (cell.i + int(v & 1)) * size,
                                                          (cell.j + int(v >> 1 & 1)) * size,
                                                          (cell.k + int(v >> 2)) * size);
      }

      void
      make_coarse_mesh()
      {
        std::vector<dealii::CellData<3>> cells;
        std::vector<dealii::Point<3>>    vertices;
        for (const Body body : both_bodies)
          {
            const SweptGrid &grid  = discretization_.grid(body);
            const int        first = static_cast<int>(vertices.size());
            vertices.resize(first + grid.n_sections() * grid.n_corners());
            for (int k = 0; k < grid.n_columns(); ++k)
              for (int b = 0; b < grid.n_blocks(); ++b)
                {
                  dealii::CellData<3> cell;
                  const auto          places = grid.coarse_vertices(b, k);
                  for (unsigned int v = 0; v < 8; ++v)
                    {
                      const int section = (k + int(v / 4)) % grid.n_sections();
                      cell.vertices[v]  = first + section * grid.n_corners() + grid.corners(b)[v % 4];
                      vertices[cell.vertices[v]] = {places[v][0], places[v][1], places[v][2]};
                    }
                  cells.push_back(cell);
                }
          }
        triangulation_.create_triangulation(vertices, cells, dealii::SubCellData());
      }

      const Discretization                           &discretization_;
      dealii::parallel::distributed::Triangulation<3> triangulation_;
    };
  } // namespace


  MeshByKeys
  p4est_mesh(const Discretization &discretization, const PerBody<FineZone> &zones, MPI_Comm communicator)
  {
    return Judge(discretization, zones, communicator).by_keys();
  }


  MeshByKeys
  program_mesh(const LocalMesh &mesh, MPI_Comm communicator)
  {
    std::vector<std::uint64_t> nodes;
    for (const auto &cell : mesh.cells)
      for (const unsigned int n : cell)
        nodes.push_back(mesh.node_key[n]);
    std::vector<Share> shares;
    for (unsigned int k = 0; k < mesh.hanging.size(); ++k)
      for (unsigned int p = mesh.hanging_begin[k]; p < mesh.hanging_begin[k + 1]; ++p)
        shares.push_back({mesh.node_key[mesh.hanging[k]], mesh.node_key[mesh.parents[p]], mesh.weights[p]});
    return of_all_ranks(mesh.cell_key, nodes, {}, shares, communicator);
  }
} // namespace test
