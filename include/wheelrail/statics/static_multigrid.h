#pragma once

#include <wheelrail/statics/coarse_solver.h>
#include <wheelrail/statics/static_level.h>

#include <memory>
#include <vector>

namespace wheelrail
{
  /// Geometric multigrid for the stiffness of both bodies with contact springs: the hierarchy of the octree's
  /// levels (coarse_levels()), each with the element kernel as operator and Chebyshev smoothing, down to the
  /// coarse blocks.
  ///
  /// Made once for a mesh. New springs are only projected to the levels.
  class StaticMultigrid
  {
  public:
    /// `held`: 1 for nodes of the solid's mesh that do not move; `ground`: on that mesh. The solid must
    /// outlive the object and keep its elements. Collective.
    StaticMultigrid(const Discretization             &discretization,
                    Solid                            &solid,
                    const std::vector<unsigned char> &held,
                    const StaticGround               &ground = {});

    /// Collective.
    void
    set_springs(const std::vector<Contact::Spring> &springs);

    /// One V-cycle from zero: z = about the displacements under the forces. Symmetric and linear but for a
    /// rough solution of the coarsest level. Collective.
    void
    cycle(const NodeVector &forces, NodeVector &z);

    StaticLevel &
    finest()
    {
      return *levels_.front();
    }

    /// Passes over elements so far, in those of the finest mesh.
    double
    passes() const;

  private:
    void
    cycle(std::size_t k, NodeVector &residual, NodeVector &x);

    MPI_Comm                                  communicator_;
    std::vector<CoarseLevel>                  coarse_;
    std::vector<PerBody<ElementBlocks>>       blocks_; ///< of the coarse levels
    std::vector<std::unique_ptr<StaticLevel>> levels_; ///< the finest first; without the coarsest
    std::unique_ptr<CoarseSolver>             coarse_solver_;
    std::vector<std::vector<unsigned char>>   held_; ///< of all levels
  };
} // namespace wheelrail
