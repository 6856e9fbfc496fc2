#pragma once

#include <wheelrail/base/vector3.h>
#include <wheelrail/geometry/contact_geometry.h>
#include <wheelrail/geometry/running_surface.h>
#include <wheelrail/geometry/wheel_pose.h>

namespace wheelrail
{
  /// Half the length of the stretch along the track where the undeformed wheel, lowered by `approach` [m],
  /// dips into the rail: half the chord of the rolling circle [m]. No patch is longer.
  double
  half_length_bound(double approach, double rolling_radius);

  /// The two running surfaces where they touch. A wheel with yaw is seen from two sides: from along the
  /// track, where the rail meets its outline, and in its own section. Without yaw both are the same.
  struct RunningSurfaces
  {
    ContactFrame   frame;
    RunningSurface rail;               ///< in `frame`
    RunningSurface wheel;              ///< in the frame of its own section, see RunningSurface
    SectionHeights outline;            ///< n(s) in `frame` of the smooth wheel seen along the track [m]
    double         rolling_radius = 0; ///< at the first contact point [m]
    double         forward_radius = 0; ///< path along the track for each angle that the wheel turns [m]

    const WheelPose &
    pose() const
    {
      return wheel.pose();
    }

    const RunningSurface &
    operator[](const Body body) const
    {
      return body == Body::rail ? rail : wheel;
    }

    /// Whether one of them has irregularities.
    bool
    irregular() const
    {
      return !rail.irregularities().empty() || !wheel.irregularities().empty();
    }

    /// Takes all heights from tables over [s0, s1] [m].
    void
    tabulate(double s0, double s1);

    /// Height in `frame` of the wheel, in its position, over the place s, z of the rail [m]: an exact circle
    /// along the track, and its irregularities.
    double
    wheel_height(double s, double z) const;

    /// Distance of the surfaces along n over the place s, z of the rail [m]; negative where they overlap.
    double
    distance(double s, double z) const
    {
      return wheel_height(s, z) - rail.at(s, z).n;
    }

    /// Velocity of the turning wheel over its pitch rate, without that of the axle, where the outline at s
    /// meets the plane Z = z [m].
    Vector3
    rolling(double s, double z) const;

    /// Local rolling radius of the wheel at s: the path along the track for each angle that it turns [m].
    double
    local_radius(double s) const
    {
      return -rolling(s, 0)[2];
    }
  };

  /// The surfaces of profiles in touch, smooth. Throws InputError as FrameProfile.
  RunningSurfaces
  running_surfaces(const Curve &head, const Curve &tread, const ContactGeometry &contact);
} // namespace wheelrail
