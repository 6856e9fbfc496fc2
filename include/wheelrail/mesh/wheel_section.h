#pragma once

#include <wheelrail/mesh/rail_section.h>

namespace wheelrail
{
  /// Wheel section dimensions [m]: rim, straight disc and hub, positions along the axle measured
  /// from the flange back towards the field side.
  struct WheelDimensions
  {
    double nominal_radius   = 0.460;
    double rim_width        = 0.135;
    double rim_inner_radius = 0.395;
    double disc_thickness   = 0.028;
    double disc_position    = 0.0675; ///< middle of the disc from the flange back
    double hub_length       = 0.175;
    double hub_position     = 0.0675; ///< middle of the hub from the flange back
    double hub_outer_radius = 0.130;
    double bore_radius      = 0.0925;
    double fillet_radius    = 0.020; ///< of the disc at rim and hub
  };

  /// Block-structured wheel section in (lateral, radius): lateral = coordinate along the axle,
  /// positive to the track centre, zero at the running circle; radius from the axle [m].
  /// `wheel_in_track` maps the wheel section frame (x to the field side, y = -F) to the track
  /// plane; the strip is given in the track plane and mapped back through it.
  /// Where the profile ends short of the field side of the rim, a chamfer of 45 degrees is added;
  /// the flange back goes straight down from the end of the profile. Edges on tread, flange face and
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
