#pragma once

#include <wheelrail/mesh/fine_strip.h>
#include <wheelrail/mesh/section.h>

namespace wheelrail
{
  /// Block-structured rail section in the track plane, fitted to the exact outline, blocks of about
  /// `block_size` [m]: head (a layer that follows the running surface around a core), web, foot.
  /// The blocks of the fine strip have one edge on the running surface each and are about
  /// `block_size` deep. The head is a ring of blocks around a core: the ring's upper corners lie in
  /// the middle of the rounded head corners, or one block beyond the strip where it reaches that far.
  /// Corners inside the head are smoothed (smooth_section).
  /// Edges on the head's sides and top are marked `running`, edges on the base `foot`.
  /// Throws InputError when the strip does not fit on the head, or the outline lacks one of the
  /// roundings that the blocks are fitted to; RunError when a block would be folded.
  Section
  make_rail_section(const RailProfile &rail,
                    const Placement   &placement,
                    const FineStrip   &strip,
                    double             block_size);
} // namespace wheelrail
