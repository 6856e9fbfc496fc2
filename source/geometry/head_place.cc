#include <wheelrail/geometry/head_place.h>

namespace wheelrail
{
  double
  gauge_face(const TrackDimensions &track)
  {
    return running_circle_distance(track) - 0.5 * track.gauge;
  }


  HeadPlace
  head_place(const Placement &rail, const TrackDimensions &track, const Point2 &point)
  {
    return {-rail.to_section(point).x, gauge_face(track) - point.x, -point.y};
  }
} // namespace wheelrail
