#pragma once

#include <wheelrail/geometry/running_surfaces.h>

#include <vector>

namespace wheelrail
{
  /// The kinks of two surfaces in a patch: by how much the slope of their distance jumps [rad].
  struct SurfaceKinks
  {
    /// The sharpest edge that presses. Under it elastic pressure has no bound: like that of a wedge, E*
    /// edge/(2 pi) arcosh(a/x) (Johnson 1985, equation 5.4).
    double edge = 0;
    /// The sharpest corner that recedes, where pressure falls to nothing.
    double notch = 0;

    void
    add(double jump);
  };

  /// A stretch along the track that is under pressure: at s across, from z0 to z1 [m].
  struct PatchRow
  {
    double s = 0, z0 = 0, z1 = 0;
  };

  /// Those under rows that lie `spacing` apart [m], and next to them: edges of irregularities along the
  /// track, joints of the profiles across it.
  SurfaceKinks
  surface_kinks(const RunningSurfaces &surfaces, const std::vector<PatchRow> &rows, double spacing);
} // namespace wheelrail
