#pragma once

#include <wheelrail/mesh/cell_tree.h>
#include <wheelrail/mesh/local_mesh.h>

#include <mpi.h>

namespace wheelrail
{
  /// Makes meshes of the forest with the finest cells wherever they are wanted, without the triangulation:
  /// from the sections and the tree of cells alone, each rank for itself, in some hundredths of a second.
  /// What the static start assembles on a Forest, the time loop goes on with on such a mesh of the same
  /// cells.
  class SweptMesh
  {
  public:
    explicit SweptMesh(SweepPlan plan);
    SweptMesh(const SweptMesh &) = delete;

    /// The part of this rank of the mesh whose finest cells lie in `zones`: as many cells a rank as any
    /// other, in the order of CellTree::leaves() that begins at `first_column`. Nodes and cells have the same
    /// numbers on any number of ranks.
    LocalMesh
    make(const PerBody<FineZone> &zones, const PerBody<int> &first_column, MPI_Comm communicator) const;

    const SweepPlan &
    plan() const
    {
      return plan_;
    }

  private:
    SweepPlan          plan_;
    PerBody<SweptGrid> grids_;
  };
} // namespace wheelrail
