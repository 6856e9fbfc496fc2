#pragma once

#include <wheelrail/base/rigid_motion.h>
#include <wheelrail/geometry/plane.h>

namespace wheelrail
{
  /// Position and angles of a wheel in the track. Its section, turned about its axle, makes
  /// the straight wheel, with the axle in the track plane Z = 0 and its lowest line below it; from there it
  /// is moved as a whole.
  struct WheelPose
  {
    Placement   section;            ///< wheel section to track plane
    double      nominal_radius = 0; ///< of the origin of the section [m]
    RigidMotion motion;             ///< of the straight wheel to its position

    /// The place at x of the section, positive to the field side [m], and at a distance from the axle [m],
    /// turned forward by `angle` from the lowest line of the straight wheel [rad].
    Vector3
    position(double x, double radius, double angle) const;

    /// That angle of the place X [rad].
    double
    angle(const Vector3 &X) const;

    /// The place X turned back about the axle to the section, in the track plane of the straight wheel.
    Point2
    on_section(const Vector3 &X) const;

    /// Of the axle, above the running circle [m].
    Vector3
    centre() const;

    /// Of the axle, a unit vector to the track centre.
    Vector3
    axis() const;

    /// Velocity of the place at X over the pitch rate, without that of the axle [m].
    Vector3
    rolling(const Vector3 &X) const;
  };
} // namespace wheelrail
