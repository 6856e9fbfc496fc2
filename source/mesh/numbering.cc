#include <wheelrail/base/gather_all.h>
#include <wheelrail/mesh/numbering.h>

#include <algorithm>
#include <limits>

namespace wheelrail
{
  namespace
  {
    using Keys = std::vector<std::uint64_t>;

    /// The keys of all ranks, ascending.
    Keys
    sorted_keys(const Keys &own, MPI_Comm communicator)
    {
      Keys all = gather_all(own, communicator);
      std::sort(all.begin(), all.end());
      return all;
    }

    std::vector<std::uint32_t>
    places(const Keys &keys, const Keys &sorted)
    {
      std::vector<std::uint32_t> number;
      for (const std::uint64_t key : keys)
        number.push_back(std::lower_bound(sorted.begin(), sorted.end(), key) - sorted.begin());
      return number;
    }

    /// The smallest key that any holder of a node gives it.
    void
    take_smallest(Keys &keys, const std::vector<Neighbour> &neighbours, MPI_Comm communicator)
    {
      std::vector<Keys>        sent, received;
      std::vector<MPI_Request> requests(2 * neighbours.size());
      for (const Neighbour &neighbour : neighbours)
        {
          sent.emplace_back();
          for (const unsigned int n : neighbour.nodes)
            sent.back().push_back(keys[n]);
          received.emplace_back(neighbour.nodes.size());
        }
      for (std::size_t k = 0; k < neighbours.size(); ++k)
        {
          const int n = static_cast<int>(sent[k].size()), rank = neighbours[k].rank;
          MPI_Irecv(received[k].data(), n, MPI_UINT64_T, rank, 0, communicator, &requests[2 * k]);
          MPI_Isend(sent[k].data(), n, MPI_UINT64_T, rank, 0, communicator, &requests[2 * k + 1]);
        }
      MPI_Waitall(static_cast<int>(requests.size()), requests.data(), MPI_STATUSES_IGNORE);
      for (std::size_t k = 0; k < neighbours.size(); ++k)
        for (std::size_t i = 0; i < received[k].size(); ++i)
          keys[neighbours[k].nodes[i]] = std::min(keys[neighbours[k].nodes[i]], received[k][i]);
    }
  } // namespace


  void
  number_cells_and_nodes(LocalMesh &mesh, MPI_Comm communicator)
  {
    mesh.cell_number = places(mesh.cell_key, sorted_keys(mesh.cell_key, communicator));

    Keys node_key(mesh.n_nodes(), std::numeric_limits<std::uint64_t>::max());
    for (std::size_t c = 0; c < mesh.cells.size(); ++c)
      for (unsigned int v = 0; v < 8; ++v)
        {
          std::uint64_t &key = node_key[mesh.cells[c][v]];
          key                = std::min(key, std::uint64_t(mesh.cell_number[c]) * 8 + v);
        }
    take_smallest(node_key, mesh.neighbours, communicator);
    Keys owned;
    for (std::size_t n = 0; n < mesh.n_nodes(); ++n)
      if (mesh.owned[n])
        owned.push_back(node_key[n]);
    mesh.node_number = places(node_key, sorted_keys(owned, communicator));
  }
} // namespace wheelrail
