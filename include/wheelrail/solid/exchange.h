#pragma once

#include <wheelrail/mesh/local_mesh.h>

#include <cstddef>
#include <vector>

#include <mpi.h>

namespace wheelrail
{
  /// Sums nodal values over the ranks that hold a node.
  ///
  /// Every holder adds the parts in the order of the ranks, so all of them get the same bits and go
  /// on integrating the node alike.
  class SharedSum
  {
  public:
    SharedSum(const LocalMesh &mesh, MPI_Comm communicator);

    /// values: `stride` numbers a node, the first `components` are summed.
    void
    operator()(double *values, int components = 3, std::size_t stride = 4);

  private:
    struct Link
    {
      int                       rank;
      std::vector<unsigned int> nodes;
      std::vector<double>       send, receive;
    };
    MPI_Comm                  communicator_;
    int                       rank_;
    std::vector<Link>         links_;  ///< ascending rank
    std::vector<unsigned int> shared_; ///< all shared nodes, once
    std::vector<double>       own_;    ///< the rank's own parts of them
  };

  /// Moves the values of hanging nodes to their parents: parent += weight x value; value = 0. Four numbers a
  /// node, which are taken at once: the first one stands at a multiple of 32 bytes (AlignedVector).
  void
  condense(const LocalMesh &mesh, double *values);

  /// Gives hanging nodes the weighted mean of their parents; values as for condense().
  void
  distribute(const LocalMesh &mesh, double *values);
} // namespace wheelrail
