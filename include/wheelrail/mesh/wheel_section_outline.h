#pragma once

#include <wheelrail/geometry/profiles.h>
#include <wheelrail/mesh/curve_stretch.h>

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

  /// What bounds the section of a wheel, in the frame (lateral, radius): lateral along the axle, positive to
  /// the track centre (right), zero at the running circle; radius from the axle [m]. The bore closes it.
  struct WheelSectionOutline
  {
    MirroredCurve rim;             ///< face, tread, flange and back, from lower left to lower right
    double        tread_start = 0; ///< parameter of `rim`
    double        back        = 0; ///< parameter of `rim` where the straight back begins
    MirroredCurve field, gauge;    ///< rim underside, disc side, hub: from the rim's end to the hub's
    double        disc = 0;        ///< middle of the disc, lateral
  };

  /// Where the profile ends short of the field side of the rim, a chamfer of 45 degrees is added; the flange
  /// back goes straight down from the end of the profile. Throws InputError when the dimensions contradict
  /// each other or the profile.
  WheelSectionOutline
  make_wheel_section_outline(const WheelProfile &profile, const WheelDimensions &dimensions);

  /// First moment of the section about the axle [m3]; times 2 pi it is the volume of the wheel (Guldin).
  double
  moment_about_axle(const WheelSectionOutline &outline, const WheelDimensions &dimensions);
} // namespace wheelrail
