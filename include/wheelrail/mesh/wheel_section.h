#pragma once

#include <wheelrail/mesh/rail_section.h>
#include <wheelrail/mesh/wheel_section_outline.h>

namespace wheelrail
{
  /// Block-structured wheel section in (lateral, radius): lateral = coordinate along the axle,
  /// positive to the track centre, zero at the running circle; radius from the axle [m].
  /// `wheel_in_track` maps the wheel section frame (x to the field side, y = -F) to the track
  /// plane; the strip is given in the track plane and mapped back through it.
  /// Its outline is that of make_wheel_section_outline(). Edges on tread, flange face and
  /// flange tip are marked `running`, edges on the bore `bore`.
  /// Throws InputError when the dimensions contradict each other or the strip does not fit on the
  /// tread; RunError when a block would be folded.
  Section
  make_wheel_section(const WheelProfile    &wheel,
                     const WheelDimensions &dimensions,
                     const Placement       &wheel_in_track,
                     const FineStrip       &strip,
                     double                 block_size);
} // namespace wheelrail
