#pragma once

#include <wheelrail/geometry/touching_profiles.h>

#include <string>

namespace wheelrail
{
  /// The part of a profile that no file holds and that lies at a place of the track plane [m]: what joins a
  /// measured head to the body below it and that body's side ("the joined side of the rail head"), or what
  /// continues a measured wheel ("the continued flange of the wheel", "the continued tread of the wheel").
  /// Empty where both surfaces are as given there.
  std::string
  made_up_part(const TouchingProfiles &profiles, const Point2 &place);
} // namespace wheelrail
