#pragma once

#include <wheelrail/contactfiles/gap_search.h>
#include <wheelrail/contactfiles/surface_shapes.h>

#include <vector>

namespace wheelrail
{
  /// The vertical gap between wheel and rail at the height 0 of the wheelset on a mesh in the track, for
  /// rails whose section changes along it; values x fastest.
  struct GapMesh
  {
    double              x0 = 0, y0 = 0, dx = 0, dy = 0; ///< first place and steps [m]
    int                 nx = 0, ny = 0;
    std::vector<double> gap;    ///< [m]; 1 where one of them is not
    std::vector<double> rail_z; ///< of the rail [m]
    std::vector<double> angle;  ///< of the rail's section under the wheelset against y, of each y

    /// At which height they first touch; 1 where they lie beside each other.
    double
    least() const;
  };

  /// The mesh is an eighth of the wheel's radius long to both sides, elements of the contact are dx by ds.
  GapMesh
  gap_mesh(const WheelRailPose &pose, const RailShape &rail, const WheelShape &wheel, double dx, double ds);

  /// The patches of a wheelset at the height of the pose: each overlap that hangs together, its place the
  /// mean weighted by the square of the overlap, joined as others are.
  std::vector<PatchPlace>
  patch_places(const GapMesh         &mesh,
               const WheelRailPose   &pose,
               const RailShape       &rail,
               const ContactElements &elements);
} // namespace wheelrail
