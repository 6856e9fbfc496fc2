#pragma once

// Contact surfaces of bodies of which the mesh holds only the half or the quarter beside planes of symmetry.

#include <wheelrail/contact/surface.h>

#include <vector>

namespace scenes
{
  /// Planes of symmetry: the mesh is x >= 0 (across), z >= 0 (along) or both.
  struct Symmetry
  {
    bool across = false, along = false;
  };

  /// Where the state of a surface node is found in the mesh.
  struct NodeSource
  {
    int                node = -1; ///< of the mesh; -1: on a rigid wheel
    wheelrail::Vector3 sign{};    ///< of the displacement, -1 across the plane behind which the node lies
    double             share = 1; ///< of its force that goes to the node: 0 from behind, 1/2 in a plane
  };

  /// A whole surface and the sources of its nodes.
  struct WholeSurface
  {
    wheelrail::Surface      surface;
    std::vector<NodeSource> sources;
  };

  /// Completes a surface of the mesh by its mirror images; its lattice must begin in the planes of symmetry.
  /// A rigid surface (local = -1) stays as it is. `global_node` is left empty.
  WholeSurface
  mirrored(const wheelrail::Surface &part, const Symmetry &symmetry);
} // namespace scenes
