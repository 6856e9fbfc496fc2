#include "rank_part.h"

#include <algorithm>
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
  rank_part(const LocalMesh &whole, const unsigned int rank, const unsigned int n_ranks)
  {
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

    part.owned.assign(part.n_nodes(), 1);
    for (unsigned int other = 0; other < n_ranks; ++other)
      if (other != rank)
        {
          const Nodes theirs = local_numbers(whole, first_cell(other), first_cell(other + 1));
          Neighbour   neighbour{static_cast<int>(other), {}};
          for (unsigned int n = 0; n < whole.n_nodes(); ++n) // the same order on both ranks
            if (local[n] != nowhere && theirs[n] != nowhere)
              {
                neighbour.nodes.push_back(local[n]);
                if (other < rank)
                  part.owned[local[n]] = 0;
              }
          if (!neighbour.nodes.empty())
            part.neighbours.push_back(neighbour);
        }
    return part;
  }
} // namespace scenes
