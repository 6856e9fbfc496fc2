#pragma once

#include <wheelrail/base/rigid_motion.h>
#include <wheelrail/base/smooth_curve.h>

namespace wheelrail
{
  /// What leads a wheelset along its path, over the path rolled since the start [SI]; shift, roll and yaw as
  /// seen from the modelled wheel (doc/manual/signs.md).
  struct GuidedPath
  {
    double      half_width = 0.75; ///< from the middle of the wheelset to the running circle [m]
    SmoothCurve lateral_shift, roll, yaw;
    SmoothCurve velocity;      ///< of the middle of the wheelset along the track
    SmoothCurve load;          ///< on the rail
    SmoothCurve torque;        ///< that drives, where the drive is a torque
    SmoothCurve pitch_rate;    ///< where it is held
    SmoothCurve contact_along; ///< first contact point ahead of the middle of the wheelset, rigid profiles
    SmoothCurve contact_ahead; ///< of the axle, likewise
    SmoothCurve forward_radius;

    /// Position and angles of the wheelset at a place of its path, against one that kept the pose of the
    /// start: the turn, and the move of the wheel's centre in the track plane and along; its height is not
    /// led [m].
    RigidMotion
    lead(double rolled) const;

    /// Change of that with the path: velocity of the centre over that of the middle of the wheelset, beside
    /// the path itself, and turning rate over it [1/m].
    struct Rate
    {
      Vector3 centre, spin;
    };
    Rate
    rate(double rolled) const;
  };
} // namespace wheelrail
