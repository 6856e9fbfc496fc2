#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/tria.h>

#include <wheelrail/base/errors.h>
#include <wheelrail/mesh/forest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace wheelrail
{
  namespace
  {
    /// Turns the blocks of a section so that opposite edges point the same way, which deal.II wants
    /// of a mesh; keeps them right-handed.
    void
    orient_blocks(Section &section)
    {
      std::vector<dealii::CellData<2>> cells(section.blocks.size());
      for (std::size_t b = 0; b < cells.size(); ++b)
        for (unsigned int v = 0; v < 4; ++v)
          cells[b].vertices[v] = section.blocks[b].corner[v];
      dealii::GridTools::consistently_order_cells(cells);
      for (std::size_t b = 0; b < cells.size(); ++b)
        {
          auto &corner = section.blocks[b].corner;
          for (unsigned int v = 0; v < 4; ++v)
            corner[v] = cells[b].vertices[v];
          const Point2 x = section.corners[corner[1]] - section.corners[corner[0]];
          const Point2 y = section.corners[corner[2]] - section.corners[corner[0]];
          if (cross(x, y) < 0)
            std::swap(corner[1], corner[2]);
        }
    }

    /// Edges of a block in deal.II's face order: left, right, bottom, top.
    constexpr unsigned int edge_corners[4][2] = {{0, 2}, {1, 3}, {0, 1}, {2, 3}};

    Boundary
    edge_mark(const Section &section, const std::array<unsigned int, 4> &corner, const unsigned int edge)
    {
      Section::EdgeKey key = {corner[edge_corners[edge][0]], corner[edge_corners[edge][1]]};
      if (key[0] > key[1])
        std::swap(key[0], key[1]);
      const auto found = section.boundary.find(key);
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
                      face.vertices[v] = base[v / 2] + block.corner[edge_corners[e][v % 2]];
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


  Forest::Forest(MPI_Comm communicator, SweepPlan plan)
    : plan_(std::move(plan))
    , triangulation_(communicator)
    , element_(dealii::FE_Q<3>(1), 3)
    , dofs_(triangulation_)
  {
    orient_blocks(plan_.rail);
    orient_blocks(plan_.wheel);
    make_coarse_mesh();
    refine();
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
      for (unsigned int v = 0; v < 8; ++v)
        {
          const auto x = position(c, {double(v & 1), double(v >> 1 & 1), double(v >> 2)});
          vertices[coarse.cells[c].vertices[v]] = dealii::Point<3>(x[0], x[1], x[2]);
        }
    triangulation_.create_triangulation(vertices, coarse.cells, coarse.faces);
  }


  std::array<double, 3>
  Forest::position(const unsigned int coarse_cell, const std::array<double, 3> &xi) const
  {
    if (coarse_cell < n_rail_cells_)
      {
        const unsigned int n_blocks = plan_.rail.blocks.size(), k = coarse_cell / n_blocks;
        const Point2       p  = plan_.rail.position(coarse_cell % n_blocks, xi[0], xi[1]);
        const double       z0 = plan_.rail_stations[k], z1 = plan_.rail_stations[k + 1];
        return {p.x, p.y, z0 + xi[2] * (z1 - z0)};
      }
    const unsigned int n_blocks = plan_.wheel.blocks.size(), k = (coarse_cell - n_rail_cells_) / n_blocks;
    const Point2       p     = plan_.wheel.position((coarse_cell - n_rail_cells_) % n_blocks, xi[0], xi[1]);
    const double       angle = 2 * M_PI * (k + xi[2]) / plan_.sectors;
    // the section's lateral coordinate points to the track centre, its placement mirrors the wheel's own x
    const Placement &place = plan_.surfaces.wheel_placement;
    const Point2     foot  = place.to_track({-p.x, plan_.surfaces.nominal_radius - p.y * std::cos(angle)});
    return {foot.x, foot.y, -p.y * std::sin(angle)};
  }


  Forest::Box
  Forest::box(const dealii::CellId &id) const
  {
    Box box{{0, 0, 0}, 1};
    for (const auto child : id.get_child_indices())
      {
        box.size /= 2;
        for (unsigned int k = 0; k < 3; ++k)
          box.corner[k] += (child >> k & 1) * box.size;
      }
    return box;
  }


  std::array<double, 3>
  Forest::vertex_position(const dealii::CellAccessor<3> &cell, const unsigned int vertex) const
  {
    const dealii::CellId id = cell.id();
    const Box            b  = box(id);
    // the coarse cell in the order of making; the number in the id is that of the p4est tree
    dealii::TriaIterator<dealii::CellAccessor<3>> ancestor(cell);
    while (ancestor->level() > 0)
      ancestor = ancestor->parent();
    return position(ancestor->index(),
                    {b.corner[0] + (vertex & 1) * b.size,
                     b.corner[1] + (vertex >> 1 & 1) * b.size,
                     b.corner[2] + (vertex >> 2) * b.size});
  }


  double
  Forest::distance_from_fine_box(const dealii::CellAccessor<3> &cell) const
  {
    const bool rail = cell.material_id() == static_cast<unsigned int>(Body::rail);
    double     low[3], high[3]; // across, depth, along
    std::fill(low, low + 3, std::numeric_limits<double>::max());
    std::fill(high, high + 3, std::numeric_limits<double>::lowest());
    for (unsigned int v = 0; v < 8; ++v)
      {
        const Vector3 X     = vertex_position(cell, v);
        const auto    place = rail ? plan_.surfaces.rail_place(X) : plan_.surfaces.wheel_place(X);
        const double  s     = std::clamp(place.s, plan_.strip.s.front(), plan_.strip.s.back());
        const double  depth =
          rail ? plan_.surfaces.rail.at(s).n - place.n : place.n - plan_.surfaces.wheel.at(s).n;
        const double value[3] = {place.s, depth, place.along};
        for (unsigned int k = 0; k < 3; ++k)
          {
            low[k]  = std::min(low[k], value[k]);
            high[k] = std::max(high[k], value[k]);
          }
      }
    const double across = std::max(low[0] - plan_.strip.s.back(), plan_.strip.s.front() - high[0]);
    const double along  = std::max(low[2] - plan_.fine_end, plan_.fine_begin - high[2]);
    return std::max({across, low[1] - plan_.fine_depth, along});
  }


  double
  Forest::cell_width(const dealii::CellAccessor<3> &cell) const
  {
    dealii::Tensor<2, 3> J; // mean edges in the rows
    for (unsigned int v = 0; v < 8; ++v)
      {
        const auto X = vertex_position(cell, v);
        for (unsigned int k = 0; k < 3; ++k)
          for (unsigned int i = 0; i < 3; ++i)
            J[k][i] += (v >> k & 1 ? 0.25 : -0.25) * X[i];
      }
    const auto inverse = dealii::symmetrize(dealii::invert(J) * dealii::transpose(dealii::invert(J)));
    return 1 / std::sqrt(dealii::eigenvalues(inverse)[0]);
  }


  void
  Forest::refine()
  {
    const double block   = (plan_.strip.s.back() - plan_.strip.s.front()) / (plan_.strip.s.size() - 1);
    const double finest  = block / std::pow(2., plan_.levels);
    const double overlap = -1e-3 * finest; // distances below count as overlap with the box
    for (unsigned int level = 0; level < plan_.levels; ++level)
      {
        // cells of 2^k finest sizes may reach up to 4 (2^k - 1) finest sizes from the finest ones
        const unsigned int k     = plan_.levels - level - 1;
        const double       reach = 4 * finest * (std::pow(2., k) - 1) - 1e-3 * finest;
        // a cell beside the box is not divided when its parts would be thinner than the finest cells
        // and so cut the stable time step (0.95: tests/stable_step.cc finds no thinner ones in the box), or
        // thinner than 0.6 of the wanted size: the whole, at most 1.2 of it, is then nearer
        const double thinnest = finest * std::max(0.95, 0.6 * std::pow(2., k));
        for (const auto &cell : triangulation_.active_cell_iterators_on_level(level))
          if (cell->is_locally_owned())
            if (const double distance = distance_from_fine_box(*cell);
                distance < reach && (distance < overlap || 0.5 * cell_width(*cell) > thinnest))
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
