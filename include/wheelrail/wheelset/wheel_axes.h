#pragma once

#include <wheelrail/base/vector3.h>
#include <wheelrail/solid/solid.h>
#include <wheelrail/wheelset/axle.h>

#include <functional>

namespace wheelrail
{
  /// Changes the displacements of the wheel between those in the track's axes and those in the axes that
  /// travel and turn with the axle.
  class WheelAxes
  {
  public:
    explicit WheelAxes(const Axle &axle);

    void
    to_wheel(Solid &solid) const;

    void
    to_track(Solid &solid) const;

  private:
    void
    change(Solid &solid, const std::function<Vector3(const Vector3 &)> &move) const;

    Axle::Motion motion_;
  };
} // namespace wheelrail
