#include <wheelrail/mesh/mesh_topology.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

namespace wheelrail
{
  namespace
  {
    constexpr unsigned int none = ~0u;

    /// Marks the nodes that a rank holds: the corners of cells, and the parents of those that hang.
    std::vector<char>
    held_nodes(const MeshTopology &mesh, const CellStretch &cells)
    {
      std::vector<char> held(mesh.key.size(), 0);
      for (std::size_t c = cells.begin; c < cells.end; ++c)
        for (const std::uint32_t node : mesh.corners[c])
          held[node] = 1;
      for (const auto &[node, parents] : mesh.hanging)
        if (held[node] == 1)
          for (const auto &parent : parents)
            held[parent.first] = std::max<char>(held[parent.first], 2);
      return held;
    }

    /// A rank's local numbers of the nodes of the whole mesh, and the arrays that they point into.
    struct RankNodes
    {
      LocalMesh                &local;
      std::vector<unsigned int> number; ///< of each node of the whole mesh; none: the rank does not hold it

      unsigned int
      operator()(const std::uint32_t node)
      {
        if (number[node] == none)
          {
            number[node] = local.global_node.size();
            local.global_node.push_back(node);
          }
        return number[node];
      }
    };

    void
    add_hanging(const MeshTopology &mesh, RankNodes &nodes)
    {
      LocalMesh &local = nodes.local;
      local.hanging_begin.push_back(0);
      const std::size_t n_vertices = local.global_node.size();
      for (unsigned int n = 0; n < n_vertices; ++n)
        if (const auto found = mesh.hanging.find(local.global_node[n]); found != mesh.hanging.end())
          {
            local.hanging.push_back(n);
            for (const auto &[parent, weight] : found->second)
              {
                local.parents.push_back(nodes(parent));
                local.weights.push_back(weight);
              }
            local.hanging_begin.push_back(local.parents.size());
          }
    }

    /// Positions of the rank's nodes, those that hang at the mean of their parents.
    void
    place_nodes(LocalMesh &local, const MeshTopology &mesh)
    {
      local.reference.assign(4 * local.n_nodes(), 0.);
      for (unsigned int n = 0; n < local.n_nodes(); ++n)
        {
          const std::uint32_t node = local.global_node[n];
          std::copy_n(mesh.position[node].begin(), 3, &local.reference[4 * n]);
          local.node_key.push_back(mesh.key[node]);
          local.node_body.push_back(static_cast<Body>(mesh.key[node] >> 62));
        }
      for (std::size_t k = 0; k < local.hanging.size(); ++k)
        {
          Vector3 mean{};
          for (unsigned int p = local.hanging_begin[k]; p < local.hanging_begin[k + 1]; ++p)
            add(mean, local.weights[p], mesh.position[local.global_node[local.parents[p]]]);
          std::copy(mean.begin(), mean.end(), &local.reference[4 * local.hanging[k]]);
        }
    }

    /// The nodes that other ranks hold too, and which ones this rank owns.
    void
    add_neighbours(const MeshTopology           &mesh,
                   const std::vector<RankCells> &shares,
                   const int                     rank,
                   RankNodes                    &nodes)
    {
      LocalMesh &local = nodes.local;
      local.owned.assign(local.n_nodes(), 1);
      for (int other = 0; other < static_cast<int>(shares.size()); ++other)
        if (other != rank)
          {
            const std::vector<char> held = held_nodes(mesh, shares[other].held);
            Neighbour               neighbour{other, {}};
            for (std::uint32_t node = 0; node < held.size(); ++node)
              if (held[node] && nodes.number[node] != none)
                {
                  neighbour.nodes.push_back(nodes.number[node]);
                  if (other < rank)
                    local.owned[nodes.number[node]] = 0;
                }
            if (!neighbour.nodes.empty())
              local.neighbours.push_back(std::move(neighbour));
          }
    }
  } // namespace


  LocalMesh
  rank_mesh(const MeshTopology &mesh, const std::vector<RankCells> &shares, const int rank)
  {
    LocalMesh        local;
    RankNodes        nodes{local, std::vector<unsigned int>(mesh.key.size(), none)};
    const RankCells &share = shares[rank];
    for (std::size_t c = share.held.begin; c < share.held.end; ++c)
      {
        std::array<unsigned int, 8> corners;
        for (unsigned int v = 0; v < 8; ++v)
          corners[v] = nodes(mesh.corners[c][v]);
        if (c < share.own.begin || c >= share.own.end)
          continue;
        local.cells.push_back(corners);
        local.cell_body.push_back(mesh.cells[c].body);
        local.cell_level.push_back(mesh.cells[c].level);
      }
    add_hanging(mesh, nodes);
    place_nodes(local, mesh);
    add_neighbours(mesh, shares, rank, nodes);
    return local;
  }
} // namespace wheelrail
