#pragma once

#include <wheelrail/output/summary.h>
#include <wheelrail/solid/solid.h>

#include <functional>

namespace wheelrail
{
  /// Small rigid motion of a part of a body in the cross-section of the contact, against its
  /// reference state carried along by the rigid motion of the body.
  struct RigidPart
  {
    double lateral  = 0; ///< of the material at the contact point, along X [m]
    double vertical = 0; ///< along Y [m]
    double roll     = 0; ///< about Z, from X to Y [rad]
    int    nodes    = 0; ///< that the fit used
  };

  /// Sums of a least-squares fit of (u_x, u_y) = (lateral - roll dy, vertical + roll dx).
  struct RigidFit
  {
    double n = 0, x = 0, y = 0, xx_yy = 0, u = 0, v = 0, moment = 0;

    /// A place at (dx, dy) from the contact point that moves by (ux, uy).
    void
    add(double dx, double dy, double ux, double uy, double weight = 1);

    RigidPart
    solve(int nodes) const;
  };

  /// Rail head and wheel rim at the contact, fitted (least squares) to the nodes of a slab of the
  /// section that lie away from the patch, where the local deformation of the contact has died out.
  struct ContactPose
  {
    RigidPart rail_head, wheel_rim;

    /// Wheel moved against the rail towards the track centre [m].
    double
    relative_lateral() const
    {
      return wheel_rim.lateral - rail_head.lateral;
    }
    /// Top of the rail turned towards the track centre against the wheel [rad], as a larger
    /// inclination of the rail would.
    double
    relative_roll() const
    {
      return wheel_rim.roll - rail_head.roll;
    }
  };

  /// Where to fit: the contact point now, and the wheel's rigid motion.
  struct PoseQuery
  {
    Vector3 contact{};        ///< [m]
    Vector3 axle_reference{}; ///< centre of the axle [m]
    Vector3 axis = {1, 0, 0}; ///< of the axle at the start
    std::function<Vector3(const Vector3 &)>
           wheel_place;              ///< of a reference place, by the wheel's rigid motion
    double head_depth       = 0.036; ///< depth of the rail head below the contact point [m]
    double rim_inner_radius = 0.395; ///< [m]
    double slab             = 0.010; ///< half thickness along Z [m]
    double keep_away        = 0.022; ///< nodes nearer to the contact point are left out [m]
  };

  /// Whether a part of head or rim that moves as a whole reaches there: (dx, dy) from the contact point, at
  /// this distance from the axle [m].
  bool
  fits_pose(const PoseQuery &query, Body body, double dx, double dy, double from_axle);

  /// Puts it into a summary, as rail_head_lateral_m and the like.
  void
  set_pose_figures(const ContactPose &pose, Summary &summary);

  /// Collective.
  ContactPose
  fit_pose(const Solid &solid, const PoseQuery &query, MPI_Comm communicator);
} // namespace wheelrail
