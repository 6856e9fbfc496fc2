#pragma once

#include <wheelrail/base/simd.h>
#include <wheelrail/statics/static_springs.h>

namespace wheelrail
{
  /// What holds the bodies of a static solution to the ground, on one mesh.
  struct StaticGround
  {
    AlignedVector<double> springs; ///< along the axes of the nodes, 4 numbers each [N/m], or empty
    StaticSprings         joined;  ///< what unknowns of parts take off them
  };
} // namespace wheelrail
