#include <deal.II/base/mpi.h>

#include <wheelrail/mesh/neighbours.h>

#include <algorithm>
#include <cstdint>
#include <unordered_map>

namespace wheelrail
{
  void
  find_neighbours(LocalMesh &mesh, MPI_Comm communicator)
  {
    const int  rank = dealii::Utilities::MPI::this_mpi_process(communicator);
    const auto all  = dealii::Utilities::MPI::all_gather(communicator, mesh.global_node);
    std::unordered_map<std::uint32_t, unsigned int> local;
    for (unsigned int n = 0; n < mesh.n_nodes(); ++n)
      local[mesh.global_node[n]] = n;
    mesh.owned.assign(mesh.n_nodes(), 1);
    mesh.neighbours.clear();
    for (int other = 0; other < static_cast<int>(all.size()); ++other)
      if (other != rank)
        {
          Neighbour neighbour{other, {}};
          for (const std::uint32_t node : all[other])
            if (const auto found = local.find(node); found != local.end())
              {
                neighbour.nodes.push_back(found->second);
                if (other < rank)
                  mesh.owned[found->second] = 0;
              }
          std::sort(neighbour.nodes.begin(), neighbour.nodes.end(), [&](unsigned int a, unsigned int b) {
            return mesh.global_node[a] < mesh.global_node[b];
          });
          if (!neighbour.nodes.empty())
            mesh.neighbours.push_back(std::move(neighbour));
        }
  }
} // namespace wheelrail
