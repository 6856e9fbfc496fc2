#pragma once

#include <wheelrail/mesh/cell_tree.h>
#include <wheelrail/mesh/local_mesh.h>
#include <wheelrail/mesh/sweep_plan.h>
#include <wheelrail/mesh/swept_grid.h>

#include <vector>

#include <mpi.h>

namespace wheelrail
{
  /// Wheel and rail as swept sections of coarse blocks, refined towards the strip where they touch: the one
  /// maker of meshes, for the start, the moving window, passages and unloading.
  ///
  /// Which cells are divided is told by CellTree, and positions come from the exact sections; hanging
  /// vertices lie at the mean of their parents. Each rank makes the topology of the whole mesh for itself, in
  /// some hundredths of a second and without messages, and takes its part.
  class Forest
  {
  public:
    /// The finest cells lie where the plan has them at the start.
    Forest(MPI_Comm communicator, SweepPlan plan);
    Forest(const Forest &) = delete;

    /// Lays the finest cells into `zones`. The ranks share the cells evenly in the order of
    /// CellTree::leaves(), which begins at `first_column`.
    void
    lay(const PerBody<FineZone> &zones, const PerBody<int> &first_column);

    /// Leaves one body alone, in its coarse blocks.
    void
    lay_blocks(Body body);

    /// The part of this rank as plain arrays. Cells and nodes have the same numbers on any number of ranks:
    /// cells in the order of their keys, nodes in that of the first (cell, vertex) that has them.
    LocalMesh
    local_mesh() const;

    /// All cells of both bodies, in the order in which the ranks share them.
    const std::vector<CellPlace> &
    cells() const
    {
      return cells_;
    }
    const SweepPlan &
    plan() const
    {
      return plan_;
    }
    const PerBody<SweptGrid> &
    grids() const
    {
      return grids_;
    }
    const SweptGrid &
    grid(const Body body) const
    {
      return grids_[body];
    }
    MPI_Comm
    communicator() const
    {
      return communicator_;
    }

  private:
    SweepPlan              plan_;
    PerBody<SweptGrid>     grids_;
    MPI_Comm               communicator_;
    std::vector<CellPlace> cells_;
  };
} // namespace wheelrail
