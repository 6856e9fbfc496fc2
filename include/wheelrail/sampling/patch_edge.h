#pragma once

#include <wheelrail/output/fields.h>

#include <array>
#include <vector>

namespace wheelrail
{
  /// The edge line of a contact patch in the (along, s) plane.
  struct PatchEdge
  {
    /// Pieces of the line, one or two per cell of the grid: along and lateral of both ends [m].
    std::vector<std::array<double, 4>> chords;

    double area      = 0; ///< inside the line, with the segments beyond the chords [m2]
    double along_min = 0, along_max = 0, lateral_min = 0, lateral_max = 0; ///< extent [m]

    unsigned int n_loaded       = 0;     ///< loaded nodes
    unsigned int n_patches      = 0;     ///< separate patches minus holes
    bool         touches_border = false; ///< the line is open at the rim of the grid
  };

  /// Finds the edge from p^2 inside and gap^(2/3) outside, see measure_patch(). A patch without
  /// pressure gives zeros. The fields must have n_along x n_lateral values.
  PatchEdge
  find_patch_edge(const PatchFields &patch);
} // namespace wheelrail
