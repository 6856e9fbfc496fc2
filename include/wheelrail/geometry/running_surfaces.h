#pragma once

#include <wheelrail/base/vector3.h>
#include <wheelrail/geometry/contact_geometry.h>
#include <wheelrail/geometry/wheel_pose.h>

#include <vector>

namespace wheelrail
{
  /// Heights of a profile over s in the contact frame as a table of cubic Hermite pieces through
  /// exact values and slopes: fast enough for every contact point in every step.
  class HeightTable
  {
  public:
    HeightTable() = default;

    /// Tabulates `profile` on [s0, s1] [m] with steps of at most `spacing` [m]. With 0.1 mm the
    /// error is below 1e-11 m even where the curvature of a standard profile jumps.
    HeightTable(const FrameProfile &profile, double s0, double s1, double spacing = 1e-4);

    /// Height and slope; outside the table the last piece is continued.
    FrameProfile::Value
    at(double s) const;

  private:
    double              begin_ = 0, spacing_ = 1;
    std::vector<double> height_, slope_;
  };

  /// Half the length of the stretch along the track where the undeformed wheel, lowered by `approach` [m],
  /// dips into the rail, by the parabola z^2 / (2 r) [m]: no patch is longer.
  double
  half_length_bound(double approach, double rolling_radius);

  /// The two running surfaces in their reference state: the rail's a cylinder along Z, the wheel's a
  /// surface of revolution about its axle. A wheel with yaw is seen in two ways: from along the track, where
  /// the rail meets its outline, and in its own section. Without yaw both are the same.
  struct RunningSurfaces
  {
    ContactFrame frame;
    HeightTable  rail, wheel;        ///< n(s) in `frame`, of the wheel its outline along the track [m]
    WheelPose    pose;               ///< of the wheel
    ContactFrame tread_frame;        ///< in the track plane of the straight wheel
    HeightTable  tread;              ///< n(s) of the wheel's section in `tread_frame` [m]
    double       rolling_radius = 0; ///< at the first contact point [m]
    double       forward_radius = 0; ///< way along the track for each angle that the wheel turns [m]

    /// Place of a reference point: contact frame coordinates (of a wheel point those of the tread frame,
    /// after turning it back to the section), and the coordinate along the track (Z, or the arc in front of
    /// the contact) [m].
    struct Place
    {
      double s = 0, n = 0, along = 0;
    };
    Place
    rail_place(const Vector3 &X) const;
    Place
    wheel_place(const Vector3 &X) const;

    /// How far the true wheel surface stands out of a reference point X of a facet, along the
    /// outward normal [m]; positive over the chords of a convex profile.
    double
    wheel_offset(const Vector3 &X) const;

    /// The same for the rail.
    double
    rail_offset(const Vector3 &X) const;

    /// Velocity of the turning wheel over its pitch rate, without that of the axle, where the outline at s
    /// meets the plane Z = z [m].
    Vector3
    rolling(double s, double z) const;

    /// Local rolling radius of the wheel at s: the way along the track for each angle that it turns [m].
    double
    local_radius(double s) const
    {
      return -rolling(s, 0)[2];
    }
  };
} // namespace wheelrail
