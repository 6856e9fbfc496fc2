#include <deal.II/base/mpi.h>

#include <wheelrail/mesh/shared_nodes.h>

#include "rank_part.h"

#include <stdexcept>

namespace scenes
{
  using namespace wheelrail;

  namespace
  {
    constexpr unsigned int nowhere = -1;

    /// Local numbers of all nodes of the whole mesh in one share of its cells, or `nowhere`.
    Nodes
    local_numbers(const LocalMesh &whole, const std::size_t begin, const std::size_t end)
    {
      Nodes        local(whole.n_nodes(), nowhere);
      unsigned int n = 0;
      for (std::size_t c = begin; c < end; ++c)
        for (const unsigned int node : whole.cells[c])
          if (local[node] == nowhere)
            local[node] = n++;
      return local;
    }
  } // namespace


  LocalMesh
  rank_part(const LocalMesh &whole, MPI_Comm communicator)
  {
    const unsigned int rank    = dealii::Utilities::MPI::this_mpi_process(communicator),
                       n_ranks = dealii::Utilities::MPI::n_mpi_processes(communicator);
    if (!whole.hanging.empty())
      throw std::logic_error("rank_part() divides meshes without hanging nodes only");
    const auto  first_cell = [&](const unsigned int r) { return whole.cells.size() * r / n_ranks; };
    const Nodes local      = local_numbers(whole, first_cell(rank), first_cell(rank + 1));

    LocalMesh part;
    Nodes     whole_node;
    for (unsigned int n = 0; n < whole.n_nodes(); ++n)
      if (local[n] != nowhere)
        {
          if (local[n] >= whole_node.size())
            whole_node.resize(local[n] + 1);
          whole_node[local[n]] = n;
        }
    for (const unsigned int n : whole_node)
      {
        part.global_node.push_back(n);
        part.node_key.push_back(n);
        part.node_body.push_back(whole.node_body[n]);
        part.reference.insert(part.reference.end(), &whole.reference[4 * n], &whole.reference[4 * n] + 4);
      }
    for (std::size_t c = first_cell(rank); c < first_cell(rank + 1); ++c)
      {
        auto cell = whole.cells[c];
        for (unsigned int &node : cell)
          node = local[node];
        part.cells.push_back(cell);
        part.cell_body.push_back(whole.cell_body[c]);
        part.cell_level.push_back(whole.cell_level[c]);
      }
    part.hanging_begin = {0};
    number_nodes(part, communicator);
    return part;
  }
} // namespace scenes
