#pragma once

#include <wheelrail/mesh/section.h>

#include <vector>

namespace wheelrail
{
  /// Moves corners inside a section, one after the other, so that the blocks around them come close
  /// to squares of `block_size` [m]: narrow, flat or skewed blocks would cut the stable time step
  /// where they are refined. With J the Jacobian of a block against its unit square, in units of
  /// block_size, the sum over all blocks of the squares of |J|^2 + |J|^2 / det(J)^2 is lowered; both
  /// terms are least for J a rotation, and the second keeps blocks from folding, or unfolds them.
  /// `movable` has one entry for each corner; corners on the boundary of the section must not be
  /// movable, nor ends of curved edges.
  void
  smooth_section(Section &section, const std::vector<bool> &movable, double block_size);
} // namespace wheelrail
