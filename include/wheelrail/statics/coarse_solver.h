#pragma once

#include <wheelrail/solid/element_blocks.h>
#include <wheelrail/statics/static_springs.h>

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <utility>
#include <vector>

namespace wheelrail
{
  class Discretization;

  /// The coarsest level of the static start: the coarse blocks of both bodies with the contact springs.
  class CoarseSolver
  {
  public:
    virtual ~CoarseSolver() = default;

    /// Takes the springs of the moment. Collective.
    virtual void
    set_springs(const StaticSprings &springs) = 0;

    /// z = the displacements under the forces, from those of the nodes that the rank owns. Collective.
    virtual void
    solve(const NodeVector &forces, NodeVector &z) = 0;
  };

  /// A direct solver where its factors take less than a gigabyte, an iterative one beyond. `blocks`: elements
  /// of rail and wheel, of which material and form count. `held`: 1 for nodes of the mesh that do not move.
  /// The direct solver leaves out what holds the wheel to the ground, the iterative one takes springs of
  /// single nodes that hold as much when all nodes move alike. Discretization and mesh must outlive the
  /// object. Collective.
  std::unique_ptr<CoarseSolver>
  make_coarse_solver(const Discretization             &discretization,
                     const LocalMesh                  &mesh,
                     const PerBody<ElementBlocks>     &blocks,
                     const std::vector<unsigned char> &held,
                     const StaticGround               &ground);

  /// Stiffness of springs between pairs of nodes (numbers over all ranks), 3 x 3, row-major [N/m].
  using SpringBlocks = std::map<std::pair<std::uint32_t, std::uint32_t>, std::array<double, 9>>;

  SpringBlocks
  spring_blocks(const StaticSprings &springs);
} // namespace wheelrail
