#pragma once

#include <wheelrail/mesh/local_mesh.h>

#include <vector>

namespace wheelrail
{
  class Discretization;

  /// A mesh with all cells beyond one level joined into their ancestors of that level, and the interpolation
  /// from it to the next finer one.
  ///
  /// Cells of lower levels are those of the mesh itself, so that every level covers both bodies and its
  /// trial functions are contained in those of the next one ("global coarsening"). A rank holds the nodes of
  /// all cells that have a part in its own mesh; `mesh.cells` lists those of them that it works on, each on
  /// one rank.
  struct CoarseLevel
  {
    /// Without boundary faces and numbers over all ranks that do not depend on the partition. The global
    /// numbers are ascending with the ranks: those of a rank's owned nodes follow one another.
    LocalMesh mesh;

    /// Value of node n of the next finer mesh = sum of weight x value of `nodes` from begin[n] to begin[n +
    /// 1]; nothing for nodes that hang there.
    std::vector<unsigned int> begin, nodes;
    std::vector<double>       weights;
  };

  /// All levels coarser than that of the finest cells, down to the coarse blocks. `finest` is the local mesh
  /// of the discretization. Collective.
  std::vector<CoarseLevel>
  coarse_levels(const Discretization &discretization, const LocalMesh &finest);
} // namespace wheelrail
