#pragma once

#include <limits>
#include <string>

namespace wheelrail
{
  /// What the commands for half-spaces take wheel and rail for.
  enum class ContactBodies
  {
    half_spaces, ///< Kalker's theory
    real,        ///< this wheel on its bore and this rail on its foot, doc/theory/bodies.md
    automatic    ///< real, or half-spaces where these cannot be: commands decide, see solve_with_bodies()
  };

  /// Where the rigid slip of the half-space contact comes from.
  enum class HalfspaceSpin
  {
    local_radius, ///< every slice rolls with its own radius and inclination
    contact       ///< one creepage and one spin, as in Kalker's program CONTACT
  };

  /// The running surface of a roller, or of a straight bar.
  struct RollerShape
  {
    double radius = 0; ///< in the rolling direction [m], 0: straight
    double crown  = 0; ///< radius across [m], 0: flat, negative: that of the file in Profiles/Wheel or /Rail
  };

  /// Contact by half-spaces and true bodies, as in subsection Half-space.
  struct HalfspaceSettings
  {
    double        halfspace_element_size   = 0.4e-3; ///< [m]
    ContactBodies halfspace_bodies         = ContactBodies::automatic;
    HalfspaceSpin halfspace_spin           = HalfspaceSpin::local_radius;
    bool          halfspace_section_normal = false; ///< of rails by slices: turned about the track alone
    double halfspace_given_spin = std::numeric_limits<double>::infinity(); ///< [1/m]; infinite: of the wheel
    double halfspace_memory_length      = 0;     ///< slip distance of the friction's memory, 0: none [m]
    double halfspace_memory_speed       = 1e-3;  ///< its least slip velocity [m/s]
    double halfspace_layer_thickness    = 0;     ///< of an interface layer, 0: none [m]
    double halfspace_layer_shear        = 8.2e9; ///< its shear modulus [Pa]
    double halfspace_lateral            = 0; ///< wheel section moved against the rail to the track centre [m]
    double halfspace_inclination        = 0; ///< rail head turned to the track centre [rad]
    std::string halfspace_distance      = "profiles"; ///< profiles, hertz, rollers, or a file of distances
    double      halfspace_radius_along  = 0.46;       ///< Hertzian distance: relative radii [m]
    double      halfspace_radius_across = 0.3;
    RollerShape wheel_roller{0.46}; ///< the rollers of a test rig
    RollerShape rail_roller;
    double      roller_width            = 10e-3; ///< of the narrower one [m]
    double      halfspace_normal_force  = 0;     ///< [N], 0: the static wheel load
    double      halfspace_approach      = 0;     ///< [m], 0: found from the normal force
    double      halfspace_contact_angle = 0;     ///< of the axle to the contact plane: the spin [rad]
  };
} // namespace wheelrail
