#pragma once

#include <wheelrail/statics/coarse_solver.h>

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

namespace dealii
{
  class DynamicSparsityPattern;
}

namespace wheelrail
{
  /// The coarsest level as a matrix, solved for roughly by conjugate gradients with smoothed aggregation
  /// (Trilinos' ML): for blocks so small that a direct solver would need gigabytes.
  class IterativeCoarseSolver : public CoarseSolver
  {
  public:
    /// See make_coarse_solver().
    IterativeCoarseSolver(const LocalMesh                  &mesh,
                          const PerBody<ElementBlocks>     &blocks,
                          const std::vector<unsigned char> &held,
                          AlignedVector<double>             ground,
                          MPI_Comm                          communicator);
    ~IterativeCoarseSolver() override;

    /// Takes the springs of the moment into the matrix and makes the preconditioner, unless those that it
    /// knows are near enough to serve on. Collective.
    void
    set_springs(const StaticSprings &springs) override;

    /// z = the displacements under the forces, to a fifth; not quite linear in them. Collective.
    void
    solve(const NodeVector &forces, NodeVector &z) override;

  private:
    struct Matrix;
    std::uint32_t
    dof(const unsigned int node, const int component) const
    {
      return 3 * mesh_.global_node[node] + component;
    }
    std::vector<std::uint32_t>
    unknowns(const std::array<unsigned int, 8> &cell) const;
    void
    make_modes();
    dealii::DynamicSparsityPattern
    pattern() const;
    void
    assemble();
    void
    make_preconditioner();
    void
    conjugate_gradients();

    const LocalMesh        &mesh_;
    AlignedVector<double>   ground_;
    MPI_Comm                communicator_;
    std::unique_ptr<Matrix> matrix_;
    unsigned int            failures_ = 0; ///< of incomplete factors as smoother, until Chebyshev's turn
  };
} // namespace wheelrail
