#pragma once

#include <wheelrail/mesh/cell_tree.h>

#include <vector>

namespace wheelrail
{
  /// Where the finest cells of a moving window lie: a stretch of each body around the place of the wheel's
  /// contact, which moves by whole coarse blocks, so that meshes at all places are alike, and columns of
  /// blocks beside it that stay fine.
  struct FineWindow
  {
    PerBody<int>              column; ///< of blocks, that the contact was in at the last move
    PerBody<std::vector<int>> kept;   ///< columns that stay fine, ascending
  };

  /// Finest cells of a body in the window of a plan, columns that are kept left out [m].
  Range
  window_range(const SweepPlan &plan, int column);

  /// All of them.
  FineZone
  window_zone(const SweepPlan &plan, int column, const std::vector<int> &kept);

  /// Moves the columns with the places of the contact on both bodies, Z of the rail and the arc coordinate of
  /// the wheel, which goes on after a turn [m]. True when a body has come to another block. The other body
  /// goes with it when it is less than a quarter of a block before its next one, so that the mesh changes
  /// once for both.
  bool
  follow(FineWindow &window, const SweepPlan &plan, const PerBody<double> &place);
} // namespace wheelrail
