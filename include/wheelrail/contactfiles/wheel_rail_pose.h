#pragma once

#include <wheelrail/base/rigid_motion.h>
#include <wheelrail/contactfiles/contact_case.h>
#include <wheelrail/contactfiles/section_line.h>

namespace wheelrail
{
  /// Velocity of a body at the origin of its axes, and its rate of turning.
  struct BodyVelocity
  {
    Vector3 velocity{}, rotation{}; ///< [m/s], [rad/s]
  };

  /// Where rail and wheel of a case of module 1 stand and how they move, in CONTACT's axes of the track: x
  /// forward, y to the right, z down [m, rad]. Left-hand cases are mirrored to the right-hand side, as
  /// CONTACT does. In shifts (T = 1) velocities are the increments of the step.
  struct WheelRailPose
  {
    bool        left = false, roller = false;
    RigidMotion rail;             ///< of its section to the track
    RigidMotion wheelset;         ///< of its axes to the track, at the height 0 (Z_WS)
    RigidMotion wheel;            ///< of its section to the wheelset
    double      height       = 0; ///< Z_WS, added to the wheelset's place
    double      wheel_radius = 0; ///< of the origin of its section

    BodyVelocity rail_motion;              ///< in the axes of the track
    Vector3      axle{}, roller_turning{}; ///< of a roller: a place of its axle, its rate; both in the track
    BodyVelocity wheelset_motion;          ///< velocity along the axes of the track, turning about its own
    BodyVelocity wheel_motion;             ///< against the wheelset, in its axes

    /// Of the wheel's section to the track, at the height.
    RigidMotion
    wheel_to_track() const;

    /// Of the wheelset to the track, at the height.
    RigidMotion
    wheelset_to_track() const;

    /// Velocity of the rail, and of the wheel, at a place of the track, and their turning, in its axes.
    BodyVelocity
    rail_at(const Vector3 &place) const;
    BodyVelocity
    wheel_at(const Vector3 &place) const;

    /// The part of the wheel's velocity there that its turning about its axle makes, and of the roller's.
    Vector3
    rolling_at(const Vector3 &place) const;
    Vector3
    roller_at(const Vector3 &place) const;
  };

  /// A turn by `roll` about x after one by `yaw` about z.
  RigidMotion
  turned_by(double roll, double yaw);

  /// The pose of a case; with N = 1 the height is 0, with F = 1 the pitch rate.
  WheelRailPose
  wheel_rail_pose(const ContactCase &one, const ProfileLine &rail);
} // namespace wheelrail
