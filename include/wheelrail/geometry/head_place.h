#pragma once

#include <wheelrail/geometry/plane.h>
#include <wheelrail/geometry/track.h>

namespace wheelrail
{
  /// Where a point lies on the head of a rail, as a gauge on the track measures it.
  struct HeadPlace
  {
    double from_axis       = 0; ///< across the rail's own section, positive to the gauge side [m]
    double from_gauge_face = 0; ///< level, from the gauge face at the gauge height to the field side [m]
    double below_top       = 0; ///< below the highest point of the inclined head [m]
  };

  /// The place of a point of the track plane [m]. `rail` is where place_rail() puts the section, which makes
  /// the gauge face lie half the gauge from the track centre.
  HeadPlace
  head_place(const Placement &rail, const TrackDimensions &track, const Point2 &point);

  /// X of the gauge face in the track plane, at the gauge height: half the gauge from the track centre [m].
  double
  gauge_face(const TrackDimensions &track);
} // namespace wheelrail
