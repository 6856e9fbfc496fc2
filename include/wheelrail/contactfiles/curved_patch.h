#pragma once

#include <wheelrail/contactfiles/patch_problem.h>

#include <vector>

namespace wheelrail
{
  /// The rows of a patch on a curved surface of reference (D = 4): the mean of rail and wheel, both followed
  /// from the contact reference by the same arc length.
  struct CurvedRows
  {
    std::vector<double>  plane; ///< across, in the plane of the reference [m]
    std::vector<Vector3> place; ///< of each row, in the track, at x of the reference
    std::vector<double>  angle; ///< of the surface against y

    bool
    empty() const
    {
      return plane.empty();
    }

    /// The arc length from the reference at a y of the track, of rows `spacing` apart of which the first has
    /// the length `first` [m].
    double
    arc_at(double y, double first, double spacing) const;
  };

  CurvedRows
  curved_rows(const WheelRailPose &pose,
              const ProfileLine   &rail,
              const WheelShape    &wheel,
              const PatchPlace    &place,
              const HalfspaceGrid &grid,
              double               origin_y);

  /// The rigid slip of each element from the velocities of both surfaces at it (D = 3, 4), in the axes of its
  /// row and along the mean of both paths; in shifts distances [m]. Returns the creepages that are nearest to
  /// it where the surfaces overlap, at the reference.
  PatchCreepages
  set_surface_slip(const WheelRailPose   &pose,
                   const PatchPlace      &place,
                   const CurvedRows      &rows,
                   const SurfaceDistance &surfaces,
                   double                 origin_x,
                   double                 origin_y,
                   HalfspaceProblem      &problem);

  /// Force on the rail and its moment about the reference, axes of the track.
  struct PatchForce
  {
    Vector3 force{}, moment{};
  };
  PatchForce
  curved_force(const PatchPlace &place, const CurvedRows &rows, double origin_x, const HalfspaceSolution &s);
} // namespace wheelrail
