#pragma once

#include <deal.II/lac/full_matrix.h>

#include <wheelrail/statics/coarse_solver.h>
#include <wheelrail/statics/swept_solver.h>

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <utility>
#include <vector>

namespace wheelrail
{
  /// The coarsest level solved for exactly. Without springs K each body is solved alone, on a rank of its own
  /// if there are two. Springs G between a few directions T, single nodes near the contact or the sums of
  /// nodes that a sleeper joins, are a correction of low rank (Woodbury): with y = K^-1 f and the compliance
  /// S = T^T K^-1 T,
  ///
  ///     x = y - K^-1 T (1 + G S)^-1 G T^T y.
  class DirectCoarseSolver : public CoarseSolver
  {
  public:
    /// See make_coarse_solver().
    DirectCoarseSolver(const Discretization             &discretization,
                       const LocalMesh                  &mesh,
                       const PerBody<ElementBlocks>     &blocks,
                       const std::vector<unsigned char> &held,
                       const StaticGround               &ground = {});

    void
    set_springs(const StaticSprings &springs) override;

    /// Exact to round-off, and linear.
    void
    solve(const NodeVector &forces, NodeVector &z) override;

  private:
    /// Where the values of a node stand among those of its body, see SweptSolver, divided by three.
    struct Place
    {
      Body         body;
      unsigned int slot;
    };

    /// Weights of a body's values, and its displacements under a unit force along them, if solved for here.
    struct Direction
    {
      Body                                        body;
      double                                      stiffness; ///< of what joins nodes [N/m]
      std::vector<std::pair<std::size_t, double>> weights;
      std::vector<double>                         response;

      double
      operator*(const std::vector<double> &x) const;
    };

    void
    find_response(Direction &direction);
    const std::array<Direction, 3> &
    directions_of(std::uint32_t node);
    void
    hold_back();
    std::vector<double>
    compliance() const;

    const LocalMesh                      &mesh_;
    MPI_Comm                              communicator_;
    std::vector<Place>                    place_;  ///< of all nodes over all ranks
    PerBody<int>                          rank_;   ///< that solves for a body
    PerBody<std::unique_ptr<SweptSolver>> solver_; ///< nothing on other ranks
    PerBody<std::vector<double>>          x_;      ///< forces, then displacements of a body

    std::vector<Direction>                            joined_;  ///< those that the ground joins
    std::map<std::uint32_t, std::array<Direction, 3>> of_node_; ///< of nodes that springs have touched
    std::vector<const Direction *>                    held_;    ///< T of the moment
    dealii::FullMatrix<double>                        couple_;  ///< (1 + G S)^-1 G
  };
} // namespace wheelrail
