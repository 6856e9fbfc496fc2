#pragma once

#include <wheelrail/base/vector3.h>
#include <wheelrail/geometry/profiles.h>
#include <wheelrail/geometry/track.h>

#include <vector>

namespace wheelrail
{
  /// The tread and flange of a wheel seen along the track: where the wheelset has a yaw, not the section
  /// through the axle but the outline of the whole wheel, the curve of the points whose normals lie across
  /// the track (the contact locus: Wang 1984). A rail is a cylinder along the track, so that wheel and rail
  /// touch in three dimensions where this outline touches the rail's section.
  struct WheelOutline
  {
    Curve               curve;      ///< in the frame of the wheel section, so that place_wheel() places it
    std::vector<double> parameters; ///< of the tread, at the joints of the curve

    /// The parameter of the tread at a parameter of the outline.
    double
    on_tread(double t) const;
  };

  /// The outline of a wheel on a wheelset with this roll, then yaw [rad]. Without yaw it is the tread.
  /// Otherwise cubics through exact points and tangents, one each 0.25 mm, which err by less than 1e-12 m,
  /// over the part around the running circle whose slope against the axle stays below 0.95 cot(yaw): steeper
  /// parts have no outline.
  WheelOutline
  wheel_outline(const WheelProfile &wheel, const TrackDimensions &track, double roll, double yaw);

  /// The axis of a wheelset in the track frame: Z counts from its middle.
  struct AxleLine
  {
    Point2  middle;    ///< X, Y [m]
    Vector3 direction; ///< unit vector to the track centre, seen from the modelled wheel

    /// A point of the wheel's surface whose normal lies across the track.
    struct SurfacePoint
    {
      double along  = 0; ///< Z [m]
      double ahead  = 0; ///< ahead of the axle, horizontally and across it [m]
      double radius = 0; ///< distance from the axle [m]
      double slope  = 0; ///< angle of the surface to the axle [rad]
    };

    /// The point of the outline at `place` of the track plane, where the outline rises by the angle `tangent`
    /// against X [rad]: the normal of a surface of revolution meets its axis.
    SurfacePoint
    surface_point(const Point2 &place, double tangent) const;
  };

  /// The axis of a wheelset whose wheel section is placed at `wheel`, with this yaw [rad].
  AxleLine
  axle_line(const Placement &wheel, const TrackDimensions &track, double yaw);
} // namespace wheelrail
