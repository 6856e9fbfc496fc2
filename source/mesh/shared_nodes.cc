#include <deal.II/base/mpi.h>

#include <wheelrail/mesh/fetch_rows.h>
#include <wheelrail/mesh/shared_nodes.h>

#include <algorithm>
#include <cstdint>
#include <map>
#include <unordered_map>
#include <utility>
#include <vector>

namespace wheelrail
{
  void
  find_neighbours(LocalMesh &mesh, MPI_Comm communicator)
  {
    struct Holder
    {
      std::uint64_t key;
      unsigned int  rank;
    };
    mesh.neighbours.clear();
    mesh.owned.assign(mesh.n_nodes(), 1);
    if (dealii::Utilities::MPI::n_mpi_processes(communicator) == 1)
      return;
    const unsigned int  here = dealii::Utilities::MPI::this_mpi_process(communicator);
    std::vector<Holder> own;
    std::unordered_map<std::uint64_t, unsigned int> number(mesh.n_nodes());
    for (unsigned int n = 0; n < mesh.n_nodes(); ++n)
      {
        own.push_back({mesh.node_key[n], here});
        number.emplace(mesh.node_key[n], n);
      }
    std::map<unsigned int, std::vector<std::uint64_t>> shared;
    for (const Holder &holder : fetch_rows(mesh.node_key, own, mesh.node_key, communicator))
      if (holder.rank != here)
        shared[holder.rank].push_back(holder.key);
    for (auto &[rank, keys] : shared)
      {
        std::sort(keys.begin(), keys.end());
        Neighbour neighbour{static_cast<int>(rank), {}};
        for (const std::uint64_t key : keys)
          {
            neighbour.nodes.push_back(number.at(key));
            if (rank < here)
              mesh.owned[number.at(key)] = 0;
          }
        mesh.neighbours.push_back(std::move(neighbour));
      }
  }
} // namespace wheelrail
