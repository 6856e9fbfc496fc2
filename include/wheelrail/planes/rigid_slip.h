#pragma once

#include <wheelrail/base/vector3.h>

#include <cmath>

// How the rail's surface slides against that of a wheel that rolls, both rigid: the one law of the static
// start, of half-spaces and of the true bodies. x along the track, s across along the plane of the contact.

namespace wheelrail
{
  /// What the wheelset does besides rolling.
  struct WheelMotion
  {
    double forward_radius   = 0; ///< R cos(yaw), path along the track for each angle that the wheel turns [m]
    bool   one_spin         = false;        ///< one creepage and one spin in place of those of every row
    double spin             = std::nan(""); ///< the one [1/m]; NaN: that of the wheel
    double lateral_creepage = 0;            ///< velocity of the wheelset along X over V
    double curvature        = 0;            ///< of its path, positive with the centre on the side of +X [1/m]
  };

  /// A place of the wheel's surface.
  struct WheelPlace
  {
    double  along         = 0;           ///< its x [m]
    double  wheel_tangent = 0;           ///< angle of the surface against X [rad]
    double  wheel_angle   = 0;           ///< and against the axle [rad]
    Vector3 from_middle   = {{0, 0, 0}}; ///< from the middle of the axle, in the track frame [m]
    Vector3 rolling       = {{0, 0, 0}}; ///< velocity over the pitch rate, in the track frame [m]
  };

  /// Rigid slip of the rail against the wheel over V, with the pitch rate V (1 + creepage) / (R cos(yaw)):
  /// along the rail for the creepage 0, and along s. V is that of the middle of the wheelset; on a curved
  /// path, seen from the wheelset, the rail at x, z comes with -V (1 - kappa x) along the track and -V kappa
  /// z along X (the frame turns with V kappa about the vertical).
  struct RigidSlip
  {
    double along = 0, lateral = 0;
  };
  RigidSlip
  rigid_slip(const WheelPlace &place, const WheelMotion &motion, double creepage);

  /// Spin of the rail against the wheel, about the normal out of the rail, for each metre of V [1/m]:
  /// sin(contact angle) / R of the wheel, and cos(contact angle) kappa of the path, with the signs of
  /// a contact angle that falls to the gauge side.
  double
  wheel_spin(const WheelPlace &place, const WheelMotion &motion, double creepage);

  /// Rigid slip of a row of elements at one s: what it is at one place of the row, and the spin about it,
  /// which is exact along the row. The small product of creepage and spin is left out.
  struct RowSlip
  {
    double along = 0, lateral = 0; ///< over V, at the place
    double spin  = 0;              ///< [1/m]
    double place = 0;              ///< its x [m]

    /// Along s, at x [m].
    double
    lateral_at(const double x) const
    {
      return lateral + spin * (x - place);
    }
  };
  RowSlip
  row_slip(const WheelPlace &place, const WheelMotion &motion, double creepage);
} // namespace wheelrail
