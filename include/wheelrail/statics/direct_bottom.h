#pragma once

#include <wheelrail/statics/static_bottom.h>
#include <wheelrail/statics/swept_solver.h>

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <vector>

namespace wheelrail
{
  /// The coarsest level solved for exactly. Without springs K each body is solved alone, on a rank of its own
  /// if there are two; springs G between the few nodes T near the contact are a correction of low rank
  /// (Woodbury): with y = K^-1 f and the compliance S = T^T K^-1 T,
  ///
  ///     x = y - K^-1 T (1 + G S)^-1 G T^T y.
  class DirectBottom : public StaticBottom
  {
  public:
    /// See make_static_bottom().
    DirectBottom(const Discretization             &discretization,
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

    void
    join(const StaticSprings &joined);
    void
    find_responses();
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

    std::vector<std::uint32_t> touched_; ///< nodes T of the springs, over all ranks
    /// K^-1 for a unit force along each direction at such a node, of bodies solved for here.
    std::map<std::uint32_t, std::array<std::vector<double>, 3>> responses_;
    std::vector<double>                                         couple_; ///< (1 + G S)^-1 G, row-major
  };
} // namespace wheelrail
