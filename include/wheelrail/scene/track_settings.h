#pragma once

#include <wheelrail/geometry/contact_geometry.h>
#include <wheelrail/scene/rail_support.h>

#include <limits>

namespace wheelrail
{
  /// Narrowest curve of a track [m]; those of trams have 20 m.
  constexpr double least_track_radius = 20;

  /// The track, as in subsections Track and Track support.
  struct TrackSettings
  {
    TrackDimensions track; ///< flange-back distance and nominal radius belong to Wheelset in the file
    double          rail_length = 1.8; ///< [m]
    SupportData     support;           ///< what the rail stands on
    double          track_radius =
      std::numeric_limits<double>::infinity();             ///< of a curve to the left; negative: right [m]
    double cant = std::numeric_limits<double>::infinity(); ///< right rail above the left [m]; infinite: none
  };
} // namespace wheelrail
