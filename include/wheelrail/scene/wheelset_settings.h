#pragma once

#include <wheelrail/geometry/contact_geometry.h>
#include <wheelrail/mesh/wheel_section_outline.h>

#include <limits>
#include <string>

namespace wheelrail
{
  /// What turns the wheel.
  enum class Drive
  {
    torque, ///< constant torque: traction coefficient x static wheel load x rolling radius
    rate    ///< pitch rate held at the prescribed creepage
  };

  /// The wheelset, its position, motion and drive, as in subsection Wheelset.
  struct WheelsetSettings
  {
    WheelDimensions wheel;               ///< Wheelset/Rim width, ... [m]
    bool            left_wheel  = false; ///< the modelled one; seen as its mirror image
    bool            both_wheels = false; ///< of the wheelset, in half-spaces
    bool            rigid_axle  = true;  ///< both wheels on it turn at one rate
    bool     pose_balances      = false; ///< lateral shift and yaw are found from the forces on the wheelset
    double   lateral_stiffness  = 0;     ///< that holds the wheelset then [N/m]
    double   yaw_stiffness      = 0;     ///< [N m/rad]
    double   centre_height      = 1.8;   ///< of the centre of gravity above the rails [m]
    double   prudhomme_factor   = 1;     ///< k of the limit of the sum of lateral forces
    double   lateral_shift      = 0;     ///< [m]
    RollMode roll               = RollMode::none;
    double   roll_angle         = 0;           ///< with RollMode::given, from X to Y [rad]
    double   yaw                = 0;           ///< angle of attack, from Z to X [rad]
    double   lateral_creepage   = 0;           ///< lateral velocity of the wheelset along X over `velocity`
    double   sprung_mass        = 10000;       ///< [kg]
    double   wheel_load         = 0;           ///< [N], 0: from the sprung mass
    double   axle_mass          = 180;         ///< half axle, rigid [kg]
    double   axle_pitch_inertia = 1.5;         ///< half axle about its own axis [kg m2]
    double   suspension_stiffness = 1.15e6;    ///< [N/m]
    double   suspension_damping   = 2500;      ///< [N s/m]
    double   velocity             = 140 / 3.6; ///< [m/s]
    Drive    drive                = Drive::torque;
    double   traction_coefficient = 0;
    double   creepage             = 0; ///< used with Drive::rate, positive driving

    std::string motion = "none"; ///< file of a motion that the run follows, or none
    double      motion_start =
      std::numeric_limits<double>::infinity(); ///< place there [m]; infinite: its first row
    double gravity = 9.81;                     ///< [m/s2]
  };
} // namespace wheelrail
