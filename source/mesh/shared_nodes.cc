#include <deal.II/base/mpi.h>

#include <wheelrail/mesh/shared_nodes.h>

#include <algorithm>
#include <cstdint>
#include <map>
#include <unordered_map>
#include <utility>
#include <vector>

namespace wheelrail
{
  namespace
  {
    using Keys = std::map<unsigned int, std::vector<std::uint64_t>>; ///< of each rank

    /// The rank that is told who holds a node: any that all find alike, and that shares the work.
    unsigned int
    meeting_place(const std::uint64_t key, const unsigned int n_ranks)
    {
      return static_cast<unsigned int>(((key * 0x9e3779b97f4a7c15u) >> 32) % n_ranks);
    }

    /// What each rank is to be told of the nodes that it named here: key and rank of another one that holds
    /// it.
    Keys
    other_holders(const Keys &named)
    {
      std::vector<std::pair<std::uint64_t, unsigned int>> all;
      for (const auto &[rank, keys] : named)
        for (const std::uint64_t key : keys)
          all.emplace_back(key, rank);
      std::sort(all.begin(), all.end());
      Keys others;
      for (std::size_t begin = 0, end; begin < all.size(); begin = end)
        {
          for (end = begin; end < all.size() && all[end].first == all[begin].first;)
            ++end;
          for (std::size_t a = begin; a < end; ++a)
            for (std::size_t b = begin; b < end; ++b)
              if (a != b)
                {
                  auto &to = others[all[a].second];
                  to.insert(to.end(), {all[a].first, all[b].second});
                }
        }
      return others;
    }
  } // namespace


  void
  find_neighbours(LocalMesh &mesh, MPI_Comm communicator)
  {
    namespace mpi              = dealii::Utilities::MPI;
    const unsigned int n_ranks = mpi::n_mpi_processes(communicator);
    mesh.neighbours.clear();
    mesh.owned.assign(mesh.n_nodes(), 1);
    if (n_ranks == 1)
      return;
    std::unordered_map<std::uint64_t, unsigned int> number(mesh.n_nodes());
    Keys                                            named, shared;
    for (unsigned int n = 0; n < mesh.n_nodes(); ++n)
      {
        number.emplace(mesh.node_key[n], n);
        named[meeting_place(mesh.node_key[n], n_ranks)].push_back(mesh.node_key[n]);
      }
    const Keys others = other_holders(mpi::some_to_some(communicator, named));
    for (const auto &told : mpi::some_to_some(communicator, others))
      for (std::size_t k = 0; k < told.second.size(); k += 2)
        shared[static_cast<unsigned int>(told.second[k + 1])].push_back(told.second[k]);
    for (auto &[rank, keys] : shared)
      {
        std::sort(keys.begin(), keys.end());
        Neighbour neighbour{static_cast<int>(rank), {}};
        for (const std::uint64_t key : keys)
          {
            neighbour.nodes.push_back(number.at(key));
            if (rank < mpi::this_mpi_process(communicator))
              mesh.owned[number.at(key)] = 0;
          }
        mesh.neighbours.push_back(std::move(neighbour));
      }
  }
} // namespace wheelrail
