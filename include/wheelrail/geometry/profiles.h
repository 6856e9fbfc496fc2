#pragma once

#include <wheelrail/geometry/curve.h>

#include <string>
#include <vector>

namespace wheelrail
{
  /// A rail section in its own frame: origin at the top of the un-inclined rail on the symmetry
  /// axis, x positive to the field side, y up [m]. The outline is closed and runs clockwise from
  /// the crown over the field side (x > 0), the base, and the gauge side back to the crown. Of a crown
  /// without sides it is empty: half-spaces alone take it.
  struct RailProfile
  {
    std::string name;
    Curve       outline;
    double      height = 0;     ///< [m]
    bool        placed = false; ///< x = 0 lies on the nominal running circle, wherever the gauge side is

    /// Running surface: open curve from the lower field-side corner of the head over the crown to
    /// the lower gauge-side corner, running towards the track centre (x descending). Curvature is
    /// positive where the rail is convex.
    Curve head;
  };

  /// A wheel tread and flange in its own frame: origin at the running circle, x positive to the
  /// field side (flange at negative x), y up = -F, the local rolling radius being r0 + F [m].
  /// The curve runs from the field side to the flange back (x descending, so that in the track
  /// plane both profiles run towards the track centre). Curvature is negative where the wheel is
  /// convex, since the steel lies to the right of the running direction.
  struct WheelProfile
  {
    std::string name;
    Curve       tread;
    bool        crown = false; ///< without flange: half-spaces alone take it
  };

  /// Names that rail_profile() and wheel_profile() accept.
  std::vector<std::string>
  standard_rails();
  std::vector<std::string>
  standard_wheels();

  /// The standard profile of that name (54E1, 60E1: EN 13674-1; S1002: EN 13715).
  /// Throws InputError that lists the known names.
  RailProfile
  rail_profile(const std::string &name);
  WheelProfile
  wheel_profile(const std::string &name);
} // namespace wheelrail
