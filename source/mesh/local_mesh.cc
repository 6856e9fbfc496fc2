#include <deal.II/base/mpi.h>
#include <deal.II/dofs/dof_accessor.h>

#include <wheelrail/base/errors.h>
#include <wheelrail/mesh/forest.h>
#include <wheelrail/mesh/neighbours.h>
#include <wheelrail/mesh/numbering.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <stdexcept>
#include <unordered_map>
#include <vector>

namespace wheelrail
{
  namespace
  {
    /// Gives local numbers to global nodes in the order of their first use.
    struct NodeNumbers
    {
      std::unordered_map<std::uint32_t, unsigned int> local;
      std::vector<std::uint32_t>                      global;

      unsigned int
      operator()(const std::uint32_t node)
      {
        const auto [entry, fresh] = local.try_emplace(node, global.size());
        if (fresh)
          global.push_back(node);
        return entry->second;
      }
    };
  } // namespace


  LocalMesh
  Forest::local_mesh() const
  {
    LocalMesh                                    mesh;
    NodeNumbers                                  number;
    std::vector<std::array<double, 3>>           position;
    std::vector<dealii::types::global_dof_index> dof(24);

    /// A node of own and ghost cells: parents may lie on ghost cells.
    struct Node
    {
      std::array<double, 3> position;
      std::uint64_t         key;
      Body                  body;
    };
    std::unordered_map<std::uint32_t, Node> known;
    for (const auto &cell : dofs_.active_cell_iterators())
      if (!cell->is_artificial())
        {
          cell->get_dof_indices(dof);
          for (unsigned int v = 0; v < 8; ++v)
            if (dof[3 * v] % 3 != 0 || dof[3 * v + 2] != dof[3 * v] + 2)
              throw std::logic_error("the three components of a vertex are not numbered together");
            else if (known.count(dof[3 * v] / 3) == 0)
              known[dof[3 * v] / 3] = {
                vertex_position(*cell, v), vertex_key(*cell, v), static_cast<Body>(cell->material_id())};
        }
    const auto add = [&](const unsigned int node, const std::uint32_t global) {
      if (node < position.size())
        return;
      const Node &data = known.at(global);
      position.push_back(data.position);
      mesh.node_key.push_back(data.key);
      mesh.node_body.push_back(data.body);
    };

    for (const auto &cell : dofs_.active_cell_iterators())
      if (cell->is_locally_owned())
        {
          const Body                  body = cell->material_id() == 0 ? Body::rail : Body::wheel;
          std::array<unsigned int, 8> nodes;
          cell->get_dof_indices(dof);
          for (unsigned int v = 0; v < 8; ++v)
            {
              nodes[v] = number(dof[3 * v] / 3);
              add(nodes[v], dof[3 * v] / 3);
            }
          mesh.cells.push_back(nodes);
          const CellPlace where = place(*cell);
          mesh.cell_key.push_back(where.key());
          mesh.cell_body.push_back(body);
          mesh.cell_level.push_back(cell->level());
          for (unsigned int f = 0; f < 6; ++f)
            if (cell->face(f)->at_boundary() && cell->face(f)->boundary_id() != 0)
              {
                // lexicographic corners of the faces of a lexicographic hexahedron
                constexpr unsigned int corner[6][4] = {
                  {0, 2, 4, 6}, {1, 3, 5, 7}, {0, 1, 4, 5}, {2, 3, 6, 7}, {0, 1, 2, 3}, {4, 5, 6, 7}};
                BoundaryFace face;
                for (unsigned int v = 0; v < 4; ++v)
                  face.nodes[v] = nodes[corner[f][v]];
                face.cell   = mesh.cells.size() - 1;
                face.mark   = static_cast<Boundary>(cell->face(f)->boundary_id());
                face.body   = body;
                face.finest = cell->level() == static_cast<int>(plan_.levels);
                face.strip  = grids_[body].in_strip(where.block);
                mesh.faces.push_back(face);
              }
        }

    // hanging nodes: the list may grow by parents, which never hang themselves after close()
    const unsigned int n_vertices = number.global.size();
    mesh.hanging_begin.push_back(0);
    for (unsigned int n = 0; n < n_vertices; ++n)
      if (const auto *entries = constraints_.get_constraint_entries(3 * number.global[n]))
        {
          mesh.hanging.push_back(n);
          for (const auto &[parent_dof, weight] : *entries)
            {
              const unsigned int parent = number(parent_dof / 3);
              add(parent, parent_dof / 3);
              mesh.parents.push_back(parent);
              mesh.weights.push_back(weight);
            }
          mesh.hanging_begin.push_back(mesh.parents.size());
        }

    mesh.global_node = number.global;
    mesh.reference.assign(4 * mesh.n_nodes(), 0.);
    for (unsigned int n = 0; n < mesh.n_nodes(); ++n)
      std::copy(position[n].begin(), position[n].end(), &mesh.reference[4 * n]);
    for (unsigned int k = 0; k < mesh.hanging.size(); ++k)
      for (unsigned int i = 0; i < 3; ++i)
        {
          double mean = 0;
          for (unsigned int p = mesh.hanging_begin[k]; p < mesh.hanging_begin[k + 1]; ++p)
            mean += mesh.weights[p] * position[mesh.parents[p]][i];
          mesh.reference[4 * mesh.hanging[k] + i] = mean;
        }
    find_neighbours(mesh, communicator());
    number_cells_and_nodes(mesh, communicator());
    return mesh;
  }
} // namespace wheelrail
