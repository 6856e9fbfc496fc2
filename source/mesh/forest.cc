#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/tria.h>

#include <wheelrail/base/errors.h>
#include <wheelrail/mesh/forest.h>

#include <algorithm>
#include <cstdint>
#include <vector>

namespace wheelrail
{
  namespace
  {
    Boundary
    edge_mark(const Section &section, const std::array<unsigned int, 4> &corner, const unsigned int edge)
    {
      const auto found = section.boundary.find(Section::edge_key(corner, edge));
      return found == section.boundary.end() ? Boundary::free : found->second;
    }

    /// Collects swept hexahedra and their boundary marks.
    struct CoarseMesh
    {
      std::vector<dealii::CellData<3>> cells;
      dealii::SubCellData              faces;

      void
      sweep(const Section     &section,
            const unsigned int stations,
            const bool         closed,
            const unsigned int first_vertex,
            const Body         body)
      {
        const unsigned int layer = section.corners.size();
        const unsigned int n     = closed ? stations : stations - 1;
        for (unsigned int k = 0; k < n; ++k)
          for (const auto &block : section.blocks)
            {
              dealii::CellData<3> cell;
              cell.material_id           = static_cast<unsigned int>(body);
              const unsigned int base[2] = {first_vertex + k * layer,
                                            first_vertex + (k + 1) % stations * layer};
              for (unsigned int v = 0; v < 8; ++v)
                cell.vertices[v] = base[v / 4] + block.corner[v % 4];
              cells.push_back(cell);
              for (unsigned int e = 0; e < 4; ++e)
                if (const Boundary mark = edge_mark(section, block.corner, e); mark != Boundary::free)
                  {
                    dealii::CellData<2> face;
                    face.boundary_id = static_cast<unsigned int>(mark);
                    for (unsigned int v = 0; v < 4; ++v)
                      face.vertices[v] = base[v / 2] + block.corner[Section::edge_corners[e][v % 2]];
                    faces.boundary_quads.push_back(face);
                  }
              for (unsigned int side = 0; side < 2; ++side)
                if (!closed && k == (side == 0 ? 0 : n - 1))
                  {
                    dealii::CellData<2> face;
                    face.boundary_id = static_cast<unsigned int>(Boundary::end);
                    for (unsigned int v = 0; v < 4; ++v)
                      face.vertices[v] = base[side] + block.corner[v];
                    faces.boundary_quads.push_back(face);
                  }
            }
      }
    };
  } // namespace


  Forest::Forest(MPI_Comm communicator, const SweepPlan &plan)
    : Forest(communicator, plan, {{plan.fine}, {plan.fine}})
  {
  }


  Forest::Forest(MPI_Comm communicator, SweepPlan plan, const PerBody<FineZone> &zones)
    : plan_(std::move(plan))
    , grids_{SweptGrid(plan_, Body::rail), SweptGrid(plan_, Body::wheel)}
    , triangulation_(communicator)
    , element_(dealii::FE_Q<3>(1), 3)
    , dofs_(triangulation_)
  {
    make_coarse_mesh();
    refine(zones);
    number();
  }


  void
  Forest::make_coarse_mesh()
  {
    const unsigned int n_rail = plan_.rail_stations.size();
    CoarseMesh         coarse;
    coarse.sweep(plan_.rail, n_rail, false, 0, Body::rail);
    n_rail_cells_                  = coarse.cells.size();
    const unsigned int first_wheel = n_rail * plan_.rail.corners.size();
    coarse.sweep(plan_.wheel, plan_.sectors, true, first_wheel, Body::wheel);

    // vertex positions through any block that has the corner
    std::vector<dealii::Point<3>> vertices(first_wheel + plan_.sectors * plan_.wheel.corners.size());
    for (unsigned int c = 0; c < coarse.cells.size(); ++c)
      {
        const CellPlace p = coarse_place(c);
        for (unsigned int v = 0; v < 8; ++v)
          {
            const auto k                          = vertex_place(p, v);
            const auto x                          = grids_[p.body].position(p.block, k[0], k[1], k[2]);
            vertices[coarse.cells[c].vertices[v]] = dealii::Point<3>(x[0], x[1], x[2]);
          }
      }
    triangulation_.create_triangulation(vertices, coarse.cells, coarse.faces);
  }


  CellPlace
  Forest::coarse_place(const unsigned int coarse_cell) const
  {
    CellPlace place;
    place.body         = coarse_cell < n_rail_cells_ ? Body::rail : Body::wheel;
    const int n        = static_cast<int>(coarse_cell - (place.body == Body::rail ? 0 : n_rail_cells_));
    const int n_blocks = grids_[place.body].n_blocks();
    place.block        = n % n_blocks;
    place.k            = n / n_blocks;
    return place;
  }


  CellPlace
  Forest::place(const dealii::CellAccessor<3> &cell) const
  {
    // the coarse cell in the order of making; the number in the id is that of the p4est tree
    dealii::TriaIterator<dealii::CellAccessor<3>> ancestor(cell);
    while (ancestor->level() > 0)
      ancestor = ancestor->parent();
    CellPlace            place = coarse_place(ancestor->index());
    const dealii::CellId id    = cell.id();
    for (const auto child : id.get_child_indices())
      place = place.child(child);
    return place;
  }


  std::array<double, 3>
  Forest::vertex_position(const dealii::CellAccessor<3> &cell, const unsigned int vertex) const
  {
    const CellPlace p = place(cell);
    const auto      v = vertex_place(p, vertex);
    return grids_[p.body].position(p.block, v[0], v[1], v[2]);
  }


  std::uint64_t
  Forest::vertex_key(const dealii::CellAccessor<3> &cell, const unsigned int vertex) const
  {
    const CellPlace p = place(cell);
    const auto      v = vertex_place(p, vertex);
    return grids_[p.body].vertex_key(p.block, v[0], v[1], v[2]);
  }


  std::array<int, 3>
  Forest::vertex_place(const CellPlace &cell, const unsigned int vertex) const
  {
    const int size = 1 << (plan_.levels - cell.level);
    return {int(cell.i + (vertex & 1)) * size,
            int(cell.j + (vertex >> 1 & 1)) * size,
            int(cell.k + (vertex >> 2)) * size};
  }


  void
  Forest::refine(const PerBody<FineZone> &zones)
  {
    const CellTree tree(plan_, grids_, zones);
    for (unsigned int level = 0; level < plan_.levels; ++level)
      {
        for (const auto &cell : triangulation_.active_cell_iterators_on_level(level))
          if (cell->is_locally_owned() && tree.divided(place(*cell)))
            cell->set_refine_flag();
        triangulation_.execute_coarsening_and_refinement();
      }
  }


  void
  Forest::number()
  {
    dofs_.distribute_dofs(element_);
    dealii::DoFTools::extract_locally_relevant_dofs(dofs_, relevant_);
    constraints_.reinit(relevant_);
    dealii::DoFTools::make_hanging_node_constraints(dofs_, constraints_);
    constraints_.close();
  }
} // namespace wheelrail
