#include <deal.II/base/partitioner.h>

#include <wheelrail/solid/exchange.h>
#include <wheelrail/solid/lanes.h>

#include <algorithm>
#include <vector>

// Hanging nodes: u_h = sum of w u_parent, f_parent += w f_h, the transpose (doc/theory/element.md, Uniform
// gradients); nodal sums over the ranks that hold a node.

namespace wheelrail
{
  void
  sum_over_ranks(const LocalMesh &mesh, double *values, const std::size_t numbers)
  {
    using dealii::ArrayView;
    using dealii::VectorOperation;
    // a single rank has the whole sums already
    if (!mesh.partitioner || mesh.partitioner->n_mpi_processes() == 1)
      return;
    if (numbers != 4)
      {
        // the partitioner counts four numbers a node: longer rows pass in groups of four
        std::vector<double> four(4 * mesh.n_nodes());
        for (std::size_t first = 0; first < numbers; first += 4)
          {
            const std::size_t n_taken = std::min<std::size_t>(4, numbers - first);
            for (std::size_t n = 0; n < mesh.n_nodes(); ++n)
              std::copy_n(values + numbers * n + first, n_taken, &four[4 * n]);
            sum_over_ranks(mesh, four.data());
            for (std::size_t n = 0; n < mesh.n_nodes(); ++n)
              std::copy_n(&four[4 * n], n_taken, values + numbers * n + first);
          }
        return;
      }
    const auto             &partitioner = *mesh.partitioner;
    std::vector<double>     sent(partitioner.n_import_indices());
    const ArrayView<double> own(values, partitioner.locally_owned_size());
    // own nodes come first, then copies of those of other ranks: both are stretches of one array
    const ArrayView<double>  ghosts(values + own.size(), partitioner.n_ghost_indices());
    const ArrayView<double>  temporary(sent.data(), sent.size());
    std::vector<MPI_Request> requests;
    // 1. Copies of nodes send their parts to the owner, which adds them; 2. the owner's sum goes back to all
    // copies, so that they hold the same bits and never part
    partitioner.import_from_ghosted_array_start(VectorOperation::add, 0, ghosts, temporary, requests);
    partitioner.import_from_ghosted_array_finish(
      VectorOperation::add, ArrayView<const double>(temporary), own, ghosts, requests);
    partitioner.export_to_ghosted_array_start(0, ArrayView<const double>(own), temporary, ghosts, requests);
    partitioner.export_to_ghosted_array_finish(ghosts, requests);
  }


  void
  condense(const LocalMesh &mesh, double *values)
  {
    // forces of hanging nodes vanish after this: their motion is no unknown
    Four *node = reinterpret_cast<Four *>(values);
    for (std::size_t k = 0; k < mesh.hanging.size(); ++k)
      {
        // f_parent += w f_hanging: the transpose of distribute(), so that power is kept
        const Four from = node[mesh.hanging[k]];
        for (unsigned int p = mesh.hanging_begin[k]; p < mesh.hanging_begin[k + 1]; ++p)
          // parents never hang themselves (2 : 1), so that one pass is enough
          node[mesh.parents[p]] += mesh.weights[p] * from;
        node[mesh.hanging[k]] = Four{0, 0, 0, 0};
      }
  }


  void
  distribute(const LocalMesh &mesh, double *values)
  {
    Four *node = reinterpret_cast<Four *>(values);
    for (std::size_t k = 0; k < mesh.hanging.size(); ++k)
      {
        // u_hanging = sum of w u_parent: on an edge the mean of two, on a face of four
        // weights sum to one: rigid and linear fields stay what they are
        Four mean = {0, 0, 0, 0};
        for (unsigned int p = mesh.hanging_begin[k]; p < mesh.hanging_begin[k + 1]; ++p)
          mean += mesh.weights[p] * node[mesh.parents[p]];
        node[mesh.hanging[k]] = mean;
      }
  }
} // namespace wheelrail
