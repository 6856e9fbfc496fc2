#pragma once

#include <wheelrail/base/vector3.h>
#include <wheelrail/geometry/frame_profile.h>
#include <wheelrail/geometry/profiles.h>
#include <wheelrail/geometry/track.h>

#include <optional>

namespace wheelrail
{
  /// A wheel as surface of revolution where its wheelset has put it, in the track frame. Its height counts
  /// from where the running circle of the straight wheel is at Y = 0.
  class PosedWheel
  {
  public:
    PosedWheel(const WheelProfile &wheel, const TrackDimensions &track, const WheelsetPose &pose);

    /// Distance from P along the unit vector `direction` to the wheel lifted by `height` [m]: positive where
    /// P is outside of it; nothing where the line misses the running surface.
    std::optional<double>
    distance(const Vector3 &P, const Vector3 &direction, double height) const;

    /// Place on the section, positive to the field side, and distance from the axle of a place in space [m].
    struct OnSection
    {
      double x = 0, radius = 0;
    };
    OnSection
    on_section(const Vector3 &P, double height) const;

    /// How far a place lies ahead of the axle, horizontally and across it [m].
    double
    ahead(const Vector3 &P) const;

    /// Of the axle above the running circle, on the wheel that is not lifted [m].
    const Vector3 &
    centre() const
    {
      return centre_;
    }

    /// Unit vector of the axle to the track centre.
    const Vector3 &
    axis() const
    {
      return axis_;
    }

  private:
    FrameProfile tread_; ///< s to the track centre, n: of the nominal radius less the radius
    double       nominal_radius_ = 0;
    Vector3      centre_, axis_;
  };
} // namespace wheelrail
