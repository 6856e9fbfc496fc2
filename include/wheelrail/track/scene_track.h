#pragma once

#include <wheelrail/scene/scene.h>
#include <wheelrail/track/track_support.h>

namespace wheelrail
{
  /// Pads and sleepers of a scene; `farther` [m]: how much farther along the rail the wheel starts, whose
  /// contact is then at Z = 0.
  TrackData
  track_data(const TrackSettings &scene, double farther = 0);
} // namespace wheelrail
