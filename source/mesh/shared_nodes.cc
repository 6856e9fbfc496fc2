#include <deal.II/base/index_set.h>
#include <deal.II/base/mpi.h>
#include <deal.II/base/partitioner.h>

#include <wheelrail/mesh/fetch_rows.h>
#include <wheelrail/mesh/shared_nodes.h>

#include <algorithm>
#include <cstdint>
#include <memory>
#include <numeric>
#include <unordered_map>
#include <utility>

namespace wheelrail
{
  namespace
  {
    namespace mpi = dealii::Utilities::MPI;

    /// `width` values a node, put in the new order.
    template <typename Values>
    void
    reorder(Values &values, const std::vector<unsigned int> &to, const std::size_t width = 1)
    {
      const Values old = values;
      for (std::size_t n = 0; n < to.size(); ++n)
        std::copy_n(&old[width * n], width, &values[width * to[n]]);
    }

    void
    reorder_nodes(LocalMesh &mesh, const std::vector<unsigned int> &to)
    {
      reorder(mesh.global_node, to);
      reorder(mesh.node_key, to);
      reorder(mesh.node_body, to);
      reorder(mesh.reference, to, 4);
      for (auto &cell : mesh.cells)
        for (unsigned int &n : cell)
          n = to[n];
      for (auto *const nodes : {&mesh.hanging, &mesh.parents})
        for (unsigned int &n : *nodes)
          n = to[n];
    }

    struct Row
    {
      std::uint64_t key;
      std::uint32_t value;
    };

    /// Of each node: the lowest rank that holds it.
    std::vector<std::uint32_t>
    lowest_holders(const std::vector<std::uint64_t> &keys, MPI_Comm communicator)
    {
      const std::uint32_t                              here = mpi::this_mpi_process(communicator);
      std::vector<Row>                                 own;
      std::unordered_map<std::uint64_t, std::uint32_t> lowest;
      for (const std::uint64_t key : keys)
        own.push_back({key, here});
      for (const Row &holder : fetch_rows(keys, own, keys, communicator))
        {
          std::uint32_t &rank = lowest.emplace(holder.key, holder.value).first->second;
          rank                = std::min(rank, holder.value);
        }
      std::vector<std::uint32_t> owner;
      for (const std::uint64_t key : keys)
        owner.push_back(lowest.at(key));
      return owner;
    }
  } // namespace


  void
  share_nodes(LocalMesh &mesh, MPI_Comm communicator)
  {
    const auto       first = mesh.n_owned > 0 ? mesh.global_node.front() : 0;
    dealii::IndexSet own(4 * mpi::sum(mesh.n_owned, communicator)), ghosts(own.size());
    own.add_range(4 * first, 4 * (first + mesh.n_owned));
    for (std::size_t n = mesh.n_owned; n < mesh.n_nodes(); ++n)
      ghosts.add_range(4 * mesh.global_node[n], 4 * mesh.global_node[n] + 4);
    mesh.partitioner = std::make_shared<mpi::Partitioner>(own, ghosts, communicator);
  }


  std::vector<unsigned int>
  number_nodes(LocalMesh &mesh, MPI_Comm communicator)
  {
    std::vector<unsigned int> order(mesh.n_nodes()), to(mesh.n_nodes());
    std::iota(order.begin(), order.end(), 0);
    if (mpi::n_mpi_processes(communicator) == 1)
      {
        mesh.n_owned = mesh.n_nodes();
        mesh.global_node.assign(order.begin(), order.end());
        share_nodes(mesh, communicator);
        return order;
      }
    const std::uint32_t              here  = mpi::this_mpi_process(communicator);
    const std::vector<std::uint32_t> owner = lowest_holders(mesh.node_key, communicator);
    mesh.n_owned                           = std::count(owner.begin(), owner.end(), here);
    std::uint32_t next                     = 0;
    MPI_Exscan(&mesh.n_owned, &next, 1, MPI_UINT32_T, MPI_SUM, communicator);
    std::vector<std::uint64_t>                       own_keys, foreign_keys;
    std::vector<Row>                                 own;
    std::unordered_map<std::uint64_t, std::uint32_t> number;
    for (std::size_t n = 0; n < owner.size(); ++n)
      if (owner[n] == here)
        {
          own_keys.push_back(mesh.node_key[n]);
          own.push_back({mesh.node_key[n], next++});
        }
      else
        foreign_keys.push_back(mesh.node_key[n]);
    for (const Row &row : own)
      number.emplace(row.key, row.value);
    for (const Row &row : fetch_rows(own_keys, own, foreign_keys, communicator))
      number.emplace(row.key, row.value);
    for (std::size_t n = 0; n < owner.size(); ++n)
      mesh.global_node[n] = number.at(mesh.node_key[n]);
    std::sort(order.begin(), order.end(), [&](const unsigned int a, const unsigned int b) {
      return std::make_pair(owner[a] != here, mesh.global_node[a]) <
             std::make_pair(owner[b] != here, mesh.global_node[b]);
    });
    for (std::size_t n = 0; n < order.size(); ++n)
      to[order[n]] = n;
    reorder_nodes(mesh, to);
    share_nodes(mesh, communicator);
    return to;
  }
} // namespace wheelrail
