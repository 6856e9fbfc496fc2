#include <wheelrail/geometry/made_up_part.h>

#include <algorithm>

namespace wheelrail
{
  namespace
  {
    /// Segment of a curve that is nearest to a place.
    std::size_t
    segment_at(const Curve &curve, const Point2 &place)
    {
      return std::min(static_cast<std::size_t>(curve.closest(place)), curve.segments().size() - 1);
    }

    /// Whether the place lies on a joined side or beyond it, seen from the middle of the head.
    bool
    on_joined_side(const Curve &head, const Point2 &place)
    {
      const auto       &segments = head.segments();
      const std::size_t at = segment_at(head, place), middle = segment_at(head, {0, 0});
      for (std::size_t k = 0; k < segments.size(); ++k)
        if (segments[k].name == "joined side" && (k < middle ? at <= k : at >= k))
          return true;
      return false;
    }
  } // namespace


  std::string
  made_up_part(const TouchingProfiles &profiles, const Point2 &place)
  {
    if (on_joined_side(profiles.rail.head, profiles.contact.rail.to_section(place)))
      return "the joined side of the rail head";
    const Curve      &tread = profiles.wheel.tread;
    const std::string name =
      tread.segments()[segment_at(tread, profiles.contact.wheel.to_section(place))].name;
    return name.rfind("continued ", 0) == 0 ? "the " + name + " of the wheel" : "";
  }
} // namespace wheelrail
