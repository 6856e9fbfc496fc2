#pragma once

#include <wheelrail/geometry/plane.h>
#include <wheelrail/geometry/profiles.h>

namespace wheelrail
{
  /// Track and wheelset dimensions [m, rad].
  struct TrackDimensions
  {
    double gauge                = 1.435;
    double gauge_height         = 0.014; ///< below the highest point of the inclined head
    double inclination          = 0.025; ///< tangent of the angle, 1/40; top towards the track centre
    double flange_back_distance = 1.360;
    double nominal_radius       = 0.460;
  };

  /// How the roll of the wheelset is found.
  enum class RollMode
  {
    none,         ///< roll is zero, the wheel is lowered onto its own rail
    from_contact, ///< both wheels touch their rails
    given         ///< an angle
  };

  /// Position and angles of a wheelset in its track.
  struct WheelsetPose
  {
    double   lateral_shift = 0; ///< along X, at the axle [m]
    RollMode roll          = RollMode::none;
    double   roll_angle    = 0; ///< with RollMode::given: about +Z, from X to Y [rad]
    double   yaw = 0; ///< about +Y through the middle of the wheelset, from Z to X, after the roll [rad]
  };

  /// Position of the other wheel of a wheelset, seen as the modelled one: its mirror image.
  WheelsetPose
  mirrored(const WheelsetPose &pose);

  /// Distance of the nominal running circle from the track centre [m]: half the flange-back
  /// distance plus the 70 mm between flange back and running circle (EN 13715).
  double
  running_circle_distance(const TrackDimensions &track);

  /// Rail placement: the track plane has X = 0 at the nominal running circle (half the flange-back
  /// distance plus 70 mm from the track centre), X positive to the track centre, and Y = 0 at the
  /// highest point of the inclined rail head. The gauge side of the head cuts the height
  /// Y = -gauge_height at half the gauge from the track centre; of a rail that is `placed` the origin of the
  /// section has X = 0 instead.
  /// Throws InputError when the head has no point at that height.
  Placement
  place_rail(const RailProfile &rail, const TrackDimensions &track);

  /// Wheel placement for a wheelset moved by `lateral_shift` [m] along X, measured at the axle, and
  /// rolled by `roll` [rad] from X to Y about the middle of its axle, which lies `axle_height` [m]
  /// above Y = 0.
  Placement
  place_wheel(const TrackDimensions &track, double lateral_shift, double roll, double axle_height);

  /// Where a point lies on the head of a rail, as a gauge on the track measures it.
  struct HeadPlace
  {
    double from_axis       = 0; ///< across the rail's own section, positive to the gauge side [m]
    double from_gauge_face = 0; ///< level, from the gauge face at the gauge height to the field side [m]
    double below_top       = 0; ///< below the highest point of the inclined head [m]
  };

  /// The place of a point of the track plane [m]. `rail` is where place_rail() puts the section, which makes
  /// the gauge face lie half the gauge from the track centre.
  HeadPlace
  head_place(const Placement &rail, const TrackDimensions &track, const Point2 &point);

  /// X of the gauge face in the track plane, at the gauge height: half the gauge from the track centre [m].
  double
  gauge_face(const TrackDimensions &track);
} // namespace wheelrail
