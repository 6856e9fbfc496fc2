#pragma once

// Round and graded bodies for scenes, of a few mapped blocks each.

#include "meshes.h"

#include <vector>

namespace scenes
{
  /// Quarter x, y >= 0 of a tube around z between 0 and `height` [m]; cells: radial, hoop, axial.
  /// `growth` is the ratio of the outermost to the innermost radial cell size.
  LocalMesh
  quarter_cylinder(double inner, double outer, double height, const Cells &cells, double growth = 1);

  /// Octant x, y, z >= 0 of a thick sphere: three blocks of n x n x radial cells.
  LocalMesh
  sphere_octant(double inner, double outer, unsigned int radial, unsigned int n, double growth = 1);

  /// Cells of a ball that touches the plane z = 0 in its south pole, the origin.
  struct BallCells
  {
    double       fine_size   = 0;     ///< size of the cells at the south pole [m]
    double       fine_radius = 0;     ///< they cover about this radius and depth [m]
    double       growth      = 1.3;   ///< ratio of neighbouring cells outside
    double       largest     = 1;     ///< limit of their growth [m]
    unsigned int upper       = 4;     ///< cells through each of the other three sides
    bool         half        = false; ///< lower half only
  };

  /// Quarter x, y >= 0 of a ball of radius R, centre (0, 0, R): a core and a block to each side, graded
  /// towards the south pole.
  LocalMesh
  quarter_ball(double radius, const BallCells &cells);

  /// Breakpoints 0 .. 1 of n cells whose sizes grow geometrically, the last `ratio` times the first.
  std::vector<double>
  graded(unsigned int n, double ratio);
} // namespace scenes
