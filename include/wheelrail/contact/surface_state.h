#pragma once

#include <wheelrail/base/vector3.h>

#include <vector>

namespace wheelrail
{
  /// Stations [first, last) of a lattice, as its indices.
  struct StationRange
  {
    int first = 0, last = 0;
  };

  inline bool
  operator==(const StationRange &a, const StationRange &b)
  {
    return a.first == b.first && a.last == b.last;
  }

  /// Places, velocities and forces of one body's surface nodes as the contact sees them, through its filters;
  /// only those of the window are kept fresh.
  struct SurfaceState
  {
    std::vector<Vector3> position;       ///< not filtered, of the rail only [m]
    std::vector<Vector3> x, reference;   ///< [m]
    std::vector<Vector3> v, slip;        ///< velocities with the normal filter and the shear filter [m/s]
    std::vector<Vector3> normal_force;   ///< [N]
    std::vector<Vector3> traction_force; ///< of shear tractions [N]
  };
} // namespace wheelrail
