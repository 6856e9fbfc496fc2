#pragma once

#include <wheelrail/geometry/frame_profile.h>
#include <wheelrail/geometry/profiles.h>
#include <wheelrail/geometry/track.h>
#include <wheelrail/geometry/wheel_outline.h>
#include <wheelrail/geometry/wheel_pose.h>

#include <string>
#include <vector>

namespace wheelrail
{
  /// A further place at which wheel and rail nearly touch: a local minimum of the gap.
  struct FurtherPoint
  {
    double       gap     = 0; ///< along the normal of the rail [m]; under load it closes by some 0.1 mm
    double       rail_x  = 0; ///< in the sections, positive to the field side [m]
    double       wheel_x = 0;
    double       angle   = 0;         ///< contact angle [rad]
    double       along   = 0;         ///< ahead of the middle of the wheelset [m]
    double       ahead   = 0;         ///< of the axle [m]
    double       rail_curvature  = 0; ///< lateral, as those of the first point [1/m]
    double       wheel_curvature = 0;
    ContactFrame frame; ///< at the point on the rail
  };

  /// The rigid contact of wheel and rail at one lateral shift ("2D-Geo").
  struct ContactGeometry
  {
    double       lateral_shift = 0; ///< along X [m]; negative: flange root towards the gauge corner
    double       roll          = 0; ///< of the wheelset about +Z (from X to Y) [rad]
    double       yaw           = 0; ///< of the wheelset about +Y (from Z to X) [rad]
    Placement    rail;              ///< rail section to track plane
    Placement    wheel;             ///< wheel section (origin: running circle point) to track plane, in touch
    WheelOutline outline;           ///< of the wheel along the track; without yaw its tread
    Point2       axle;              ///< point of the axle above the running circle, in the track plane [m]
    ContactFrame frame;             ///< at the first contact point
    double       rail_x  = 0;       ///< in the rail section, positive to the field side [m]
    double       rail_y  = 0;
    double       wheel_x = 0; ///< in the wheel section, positive to the field side [m]
    double       wheel_y = 0;
    double       angle   = 0; ///< contact angle, positive when the tangent falls to the gauge side [rad]
    AxleLine     axis;        ///< of the wheelset
    WheelPose    pose;        ///< of the wheel, with Z and the angle about the axle counted from the point
    ContactFrame tread_frame; ///< at the point of the tread, in the track plane of the straight wheel
    double       along           = 0; ///< Z of the point, ahead of the middle of the wheelset [m]
    double       ahead           = 0; ///< of the point, ahead of the axle, across the axle's direction [m]
    double       rolling_radius  = 0; ///< [m]
    double       forward_radius  = 0; ///< path along the track for each angle that the wheel turns [m]
    double       other_radius    = 0; ///< rolling radius of the other wheel of the wheelset [m]
    double       rail_curvature  = 0; ///< lateral, at the point, positive convex [1/m]
    double       wheel_curvature = 0; ///< lateral, positive convex, negative concave [1/m]
    std::string  rail_segment, wheel_segment;
    double       second_gap = 0; ///< vertical gap at the next local minimum [m], negative when there is none
    double       second_rail_x = 0;    ///< where it lies in the rail section [m]
    std::vector<FurtherPoint> further; ///< all other local minima with a common tangent, nearest first
  };

  /// What rolls on the other side of a wheelset.
  struct WheelOnRail
  {
    const RailProfile  &rail;
    const WheelProfile &wheel;
  };

  /// Finds the first contact point of the modelled (right-hand) wheel: the wheel is lowered
  /// vertically onto its rail; with yaw its outline along the track is (wheel_outline()), which is the
  /// contact in three dimensions. With RollMode::from_contact the roll is such that the other wheel, the
  /// mirror image (or `other`) with shift, roll and yaw of opposite sign, touches at the same axle height.
  ///
  /// The shift must also be possible for the other wheel, in both roll modes. Throws InputError
  /// when at this shift one of the wheels does not touch its rail with a common tangent (tread edge,
  /// flange above the rail); the message says which shifts are possible.
  ContactGeometry
  find_contact(const RailProfile     &rail,
               const WheelProfile    &wheel,
               const TrackDimensions &track,
               const WheelsetPose    &pose,
               const WheelOnRail     *other = nullptr);
} // namespace wheelrail
