#include <wheelrail/base/errors.h>
#include <wheelrail/bodies/section_mesh.h>

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_tools.h>
#include <deal.II/grid/cell_id.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/tria.h>
#include <deal.II/lac/affine_constraints.h>

#include <cstdint>
#include <map>

// Nine-node quadrilaterals of a section: blocks as those of a run, halved towards the running surface;
// hanging nodes from deal.II, as the edge of the coarse cell has them.

namespace wheelrail
{
  namespace
  {
    using Triangulation = dealii::Triangulation<2>;

    /// Makes the blocks and tells where the corners of each as deal.II orders them lie in the block: deal.II
    /// wants opposite edges to run in the same sense.
    std::vector<std::array<Point2, 4>>
    make_blocks(const Section &section, Triangulation &triangulation)
    {
      // corners may be listed in another order afterwards: `places` are their coordinates 0 or 1 in the block
      // as the section has it
      std::vector<dealii::Point<2>> corners;
      for (const Point2 &p : section.corners)
        corners.emplace_back(p.x, p.y);
      std::vector<dealii::CellData<2>> blocks;
      for (const Section::Block &block : section.blocks)
        {
          blocks.emplace_back();
          blocks.back().vertices.assign(block.corner.begin(), block.corner.end());
        }
      dealii::GridTools::consistently_order_cells(blocks);
      std::vector<std::array<Point2, 4>> places(blocks.size());
      for (unsigned int b = 0; b < blocks.size(); ++b)
        for (unsigned int v = 0; v < 4; ++v)
          for (unsigned int c = 0; c < 4; ++c)
            // (0, 0), (1, 0), (0, 1), (1, 1) in the block of the section
            if (section.blocks[b].corner[c] == blocks[b].vertices[v])
              places[b][v] = {double(c % 2), double(c / 2)};
      // marks of edges are boundary numbers of deal.II
      dealii::SubCellData edges;
      for (const auto &[key, boundary] : section.boundary)
        {
          edges.boundary_lines.emplace_back();
          edges.boundary_lines.back().vertices.assign(key.begin(), key.end());
          edges.boundary_lines.back().boundary_id = static_cast<dealii::types::boundary_id>(boundary);
        }
      triangulation.create_triangulation(corners, blocks, edges);
      return places;
    }


    bool
    is_on(const Triangulation::cell_iterator &cell, const unsigned int face, const Boundary boundary)
    {
      return cell->at_boundary(face) &&
             cell->face(face)->boundary_id() == static_cast<dealii::types::boundary_id>(boundary);
    }


    void
    refine(Triangulation &triangulation, const unsigned int levels)
    {
      // three halvings of 16 mm: 2 mm along the surface, where influences are asked for
      for (unsigned int level = 0; level < levels; ++level)
        {
          for (const auto &cell : triangulation.active_cell_iterators())
            for (unsigned int face = 0; face < 4; ++face)
              if (is_on(cell, face, Boundary::running))
                // deal.II divides neighbours, too, where sizes would differ by more than 2 : 1
                cell->set_refine_flag();
          triangulation.execute_coarsening_and_refinement();
        }
    }


    /// Block and lower left corner of a cell in its block, in parts of the block's edges.
    struct Place
    {
      unsigned int block = 0;
      double       xi = 0, eta = 0, size = 1;
    };
    Place
    place_of(const Triangulation::cell_iterator &cell)
    {
      // bit 0 of a child: the right half; bit 1: the upper one (deal.II's order)
      Place                place;
      const dealii::CellId id = cell->id();
      place.block             = id.get_coarse_cell_id();
      for (const std::uint8_t child : id.get_child_indices())
        {
          // parts of the block's edges: exact in binary
          place.size *= 0.5;
          place.xi += (child & 1) ? place.size : 0;
          place.eta += (child & 2) ? place.size : 0;
        }
      return place;
    }


    /// Hanging nodes with their masters: the weights are the values of the coarse edge's quadratic there.
    std::vector<SectionMesh::Hanging>
    hanging_nodes(const dealii::AffineConstraints<double> &constraints)
    {
      // u_node = sum of weights x u_master, along each axis
      std::vector<SectionMesh::Hanging> hanging;
      for (const auto &line : constraints.get_lines())
        {
          // on an edge of half the size the middle node hangs, too: 3/8, 3/4, -1/8 of the coarse edge's three
          hanging.emplace_back();
          hanging.back().node = line.index;
          for (const auto &[master, weight] : line.entries)
            {
              hanging.back().masters.push_back(master);
              hanging.back().weights.push_back(weight);
            }
        }
      return hanging;
    }

    /// Orders edges end to end; the running surface goes towards the track centre with the material on its
    /// right.
    std::vector<SectionMesh::Edge>
    in_order(const std::vector<SectionMesh::Edge> &edges)
    {
      std::map<unsigned int, SectionMesh::Edge> from;
      std::map<unsigned int, int>               ends;
      for (const auto &edge : edges)
        {
          // edges begin and end at nodes that they share, so that the line follows from node to node
          from[edge.node[0]] = edge;
          // an end of the line is a node where an edge begins and none ends
          ++ends[edge.node[0]];
          --ends[edge.node[2]];
        }
      std::vector<unsigned int> starts;
      for (const auto &[node, balance] : ends)
        if (balance > 0)
          starts.push_back(node);
      std::vector<SectionMesh::Edge> ordered;
      if (starts.size() == 1)
        for (auto next = from.find(starts[0]); next != from.end(); next = from.find(ordered.back().node[2]))
          ordered.push_back(next->second);
      if (ordered.size() != edges.size())
        throw RunError(
          "The running surface of a section is not one line of cells, so that its elasticity cannot "
          "be computed.");
      return ordered;
    }
  } // namespace


  SectionMesh
  mesh_section(const Section &section, const Boundary held, const unsigned int levels)
  {
    Triangulation triangulation;
    const auto    corner_places = make_blocks(section, triangulation);
    refine(triangulation, levels);
    // nine nodes: FE_Q of degree 2
    const dealii::FE_Q<2> element(2);
    dealii::DoFHandler<2> handler(triangulation);
    handler.distribute_dofs(element);
    dealii::AffineConstraints<double> constraints;
    dealii::DoFTools::make_hanging_node_constraints(handler, constraints);
    constraints.close();

    SectionMesh mesh;
    mesh.nodes.resize(handler.n_dofs());
    // 1. Nodes of each cell; 2. edges of the running surface and held nodes; 3. hanging nodes; 4. the surface
    // in order
    std::vector<char>                            is_held(handler.n_dofs(), 0);
    std::vector<dealii::types::global_dof_index> dofs(9);
    // deal.II numbers corners, lines and the middle in turn; here three rows of three
    const std::vector<unsigned int> place_in_cell =
      dealii::FETools::lexicographic_to_hierarchic_numbering<2>(2);
    // nodes of a cell's faces, in rows of three: left, right, bottom, top; with the material on the right
    constexpr unsigned int         face_node[4][3] = {{0, 3, 6}, {8, 5, 2}, {2, 1, 0}, {6, 7, 8}};
    std::vector<SectionMesh::Edge> running;
    for (const auto &cell : handler.active_cell_iterators())
      {
        cell->get_dof_indices(dofs);
        std::array<unsigned int, 9> nodes;
        const Place                 place = place_of(cell);
        for (unsigned int n = 0; n < 9; ++n)
          {
            const auto  &corner = corner_places[place.block];
            const double xi     = place.xi + 0.5 * (n % 3) * place.size,
                         eta    = place.eta + 0.5 * (n / 3) * place.size;
            // bilinear place in the block, then the block's own curved edges: nodes of cells at the surface
            // lie on the profile
            const Point2 in_block = corner[0] + xi * (corner[1] - corner[0]) + eta * (corner[2] - corner[0]);
            nodes[n]              = dofs[place_in_cell[n]];
            mesh.nodes[nodes[n]]  = section.position(place.block, in_block.x, in_block.y);
          }
        mesh.cells.push_back(nodes);
        for (unsigned int face = 0; face < 4; ++face)
          {
            const auto &n = face_node[face];
            if (is_on(cell, face, Boundary::running))
              running.push_back({{{nodes[n[0]], nodes[n[1]], nodes[n[2]]}}});
            if (is_on(cell, face, held))
              for (const unsigned int node : n)
                is_held[nodes[node]] = 1;
          }
      }
    // from refinement alone: neighbours differ by one level
    mesh.hanging = hanging_nodes(constraints);
    for (unsigned int node = 0; node < is_held.size(); ++node)
      if (is_held[node])
        mesh.held.push_back(node);
    // from the field side to the track centre, the material on the right
    mesh.running = in_order(running);
    return mesh;
  }
} // namespace wheelrail
