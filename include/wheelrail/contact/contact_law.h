#pragma once

#include <wheelrail/base/body.h>
#include <wheelrail/contact/projection.h>
#include <wheelrail/contact/surface_filter.h>
#include <wheelrail/material/friction.h>

namespace wheelrail
{
  /// Constants of the contact law.
  ///
  /// Pressure p = stiffness x penetration + damping x closing speed, never negative; shear traction
  /// by elastic trial with `stiffness` and return to the bound mu(v) x p, v the slip velocity
  /// (equations 2 and 3 of Ma, Markine, Mashal and Ren 2017, as tractions instead of forces).
  struct ContactLaw
  {
    double                 stiffness = 0; ///< eps, normal and tangential [N/m3]
    double                 damping   = 0; ///< [N s/m3]
    FrictionLaw            friction;
    PerBody<SurfaceFilter> filter;
    double                 added_mass = 0; ///< on the surface nodes of both bodies [kg/m2]
  };

  /// State of one rail node that may touch the wheel. Tractions act on the rail.
  struct ContactNode
  {
    double     gap      = 1; ///< along the normal, negative in contact [m]
    double     pressure = 0; ///< [Pa]
    Vector3    normal{};     ///< out of the rail
    Vector3    elastic{};    ///< part of the shear traction that its spring bears, the history [Pa]
    Vector3    traction{};   ///< shear traction with its damping part [Pa]
    Vector3    slip{};       ///< velocity of the wheel against the rail that the spring does not take [m/s]
    bool       slipping = false;
    FacetPoint foot; ///< closest point on the wheel
  };

  /// Sums over the contact at one instant. Forces act on the wheel.
  struct ContactSums
  {
    Vector3 force{};                  ///< [N]
    Vector3 moment{};                 ///< of the forces about the origin of the track frame [N m]
    double  normal_force     = 0;     ///< sum of p A [N]
    double  stored_energy    = 0;     ///< in the penalty springs [J]
    double  friction_power   = 0;     ///< [W]
    double  damping_power    = 0;     ///< [W]
    double  largest_pressure = 0;     ///< [Pa]
    int     nodes            = 0;     ///< in contact
    bool    at_border        = false; ///< the patch touches the border of the window

    ContactSums &
    operator+=(const ContactSums &other);
  };

  /// How the wheel moves against the rail at a node.
  struct ContactMotion
  {
    double  opening = 0; ///< velocity along the normal [m/s]
    Vector3 slip{};      ///< velocity in the tangent plane, with what the spring takes [m/s]
    Vector3 tilt{};      ///< of the true normal against that of the wheel's facets, see Facing
  };

  /// Forces of one node on the wheel [N]; the opposite acts on the rail.
  struct ContactForces
  {
    Vector3 push, drag; ///< of the pressure, of the shear traction
  };

  /// Pressure and shear traction of a node from its gap, normal and motion; its history is updated over
  /// `time_step` [s], 0: at rest, the spring keeps its traction. `area` [m2]. Adds to the sums.
  ContactForces
  apply_law(const ContactLaw    &law,
            const ContactMotion &motion,
            double               time_step,
            double               area,
            ContactNode         &node,
            ContactSums         &sums);
} // namespace wheelrail
