#pragma once

#include <wheelrail/contactfiles/gap_search.h>
#include <wheelrail/contactfiles/surface_shapes.h>
#include <wheelrail/contactfiles/wheel_rail_case.h>
#include <wheelrail/halfspace/problem.h>

#include <vector>

namespace wheelrail
{
  /// The creepages of a patch at its contact reference, the rail against the wheel, over CONTACT's reference
  /// velocity; in shifts distances [m].
  struct PatchCreepages
  {
    double velocity = 1;           ///< mean of forward and rolling speed [m/s]; 1 in shifts
    double x = 0, y = 0, spin = 0; ///< [-], [1/m]
    bool   backwards = false;      ///< CHI = 180d
  };

  /// Those of a wheel that stands `approach` deeper than touching at the reference [m].
  PatchCreepages
  patch_creepages(const WheelRailPose &pose, const PatchPlace &place, double approach, bool shift);

  /// The grid over a patch, in its plane: elements whose centres are whole elements away from the contact
  /// reference or, in shifts and transient rolling, from the origin of CONTACT's fixed grid; with one element
  /// more around the overlap. Coarser by factors of two above NPOT_MAX elements.
  HalfspaceGrid
  patch_grid(const ContactCase &one, const PatchPlace &place, double origin_x, double origin_y);

  /// The undeformed surfaces along the normal of a plane [m].
  struct SurfaceDistance
  {
    std::vector<double>
      gap; ///< of the rail's surface to the wheel's, positive apart; far apart where one is not
    std::vector<double> rail; ///< place of the rail's surface, counted into the rail; 0 where it is not
  };

  /// Distance of the rail's surface to the wheel's along the normal of the plane, at the centres of a grid
  /// whose point (origin_x, origin_y) is the contact reference; positive apart. Where one of them does not
  /// lie there: far apart. `rows`: their places across in the plane, from the reference [m].
  SurfaceDistance
  patch_distance(const WheelRailPose       &pose,
                 const RailShape           &rail,
                 const WheelShape          &wheel,
                 const PatchPlace          &place,
                 const HalfspaceGrid       &grid,
                 double                     origin_x,
                 double                     origin_y,
                 const std::vector<double> &rows);

  /// The friction of a patch: of the case, or between its lines by the angle of contact in the axes of the
  /// wheel (V = 1) or by S_WS (V = 2).
  ContactFrictionLine
  patch_friction(const ContactCase &one, double wheel_angle);

  /// Axes of a patch: x along the track, y across in its plane, z into the rail.
  RigidMotion
  patch_axes(const PatchPlace &place);
} // namespace wheelrail
