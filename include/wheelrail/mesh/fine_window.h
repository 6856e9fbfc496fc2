#pragma once

#include <wheelrail/mesh/cell_tree.h>

#include <limits>
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
    PerBody<int> start = {0, 0};      ///< column of the first contact of the wheel that the window follows

    /// How far the contact is to come on each body [m]: in the first block, what lies further than
    /// SweepPlan::reach beyond that needs no fine cells, nor what lies so far behind the start.
    PerBody<double> path_end = {std::numeric_limits<double>::max(), std::numeric_limits<double>::max()};
  };

  /// Finest cells of a body in a window, columns that are kept left out [m]; those of the plan where they do
  /// not move.
  Range
  window_range(const SweepPlan &plan, const FineWindow &window, Body body);

  /// The part of the strip in which they lie [m].
  Range
  window_across(const SweepPlan &plan, const FineWindow &window);

  /// All of them, and the whole strip in columns that are kept.
  FineZone
  window_zone(const SweepPlan &plan, const FineWindow &window, Body body);

  /// Moves the columns with the places of the contact on both bodies, Z of the rail and the arc coordinate of
  /// the wheel, which goes on after a turn [m]. True when a body has come to another block. The other body
  /// goes with it when it is less than a quarter of a block before its next one, so that the mesh changes
  /// once for both. A wheel that spins beyond the end of the path has no end any more.
  bool
  follow(FineWindow &window, const SweepPlan &plan, const PerBody<double> &place);
} // namespace wheelrail
