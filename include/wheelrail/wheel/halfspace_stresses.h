#pragma once

#include <wheelrail/mesh/local_mesh.h>
#include <wheelrail/sampling/slices.h>
#include <wheelrail/wheel/halfspace_case.h>

#include <vector>

namespace wheelrail
{
  /// The stresses in rail and wheel below the contact of two half-spaces.
  struct HalfspaceStresses
  {
    /// AA and BB through the first contact point (or, where the grid does not reach it, the element next to
    /// it), AA_peak and BB_peak through the element of the largest pressure, of rail and wheel: in the form,
    /// the axes and with the signs of a run's (slices.h). The half-spaces are plane: depth counts from the
    /// contact plane, and the planes stand on the mean inclination of the surfaces.
    /// Of several patches the first one.
    std::vector<Slice> slices;

    /// Largest von Mises stress at the surface of all patches, where it follows from friction [Pa].
    double surface_von_mises = 0;
    /// Largest of the maxima over depth of the von Mises stress below an element, and its depth, by the
    /// parabola through three layers; 0 when the stress falls from the surface everywhere [Pa], [m].
    double subsurface_von_mises = 0, subsurface_depth = 0;
    Body   subsurface_body = Body::rail;
  };

  /// Computes them (SubsurfaceLayers) at the element centres, every half element but not below every 0.2 mm
  /// or 16th of the shorter extent of the patch, down to 15 mm or three quarters of that extent.
  HalfspaceStresses
  halfspace_stresses(const WheelRailSolution &result);
} // namespace wheelrail
