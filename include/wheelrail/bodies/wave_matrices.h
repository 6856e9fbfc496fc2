#pragma once

#include <wheelrail/bodies/section_mesh.h>
#include <wheelrail/material/elasticity.h>

#include <array>
#include <functional>
#include <utility>
#include <vector>

namespace wheelrail
{
  /// Stiffness and mass of a section for displacements that go like a wave along the body, see WaveStiffness:
  /// K = K0 + k K1 + k^2 K2 and M, of a rail for each metre, of a wheel for each radian; real and symmetric.
  struct WaveMatrices
  {
    /// Of each node of the mesh the free nodes that it moves with, and how much: one for a node that is free,
    /// none for one that is held, several for one that hangs.
    std::vector<std::vector<std::pair<int, double>>> unknowns;
    int n_free = 0, n_surface = 0; ///< free nodes; those of the running surface come last
    /// The lower half, column by column, of 3 n_free displacements (x, y, w of each free node).
    std::vector<int>                   start, row;
    std::array<std::vector<double>, 4> values; ///< of K0, K1, K2 [N/m2, N/m, N], M [kg/m]

    int
    size() const
    {
      return 3 * n_free;
    }
  };

  /// Throws RunError where a cell is folded.
  WaveMatrices
  assemble_waves(const SectionMesh &mesh, const Elasticity &elasticity, bool wheel);

  /// Integrals over an edge of its three shape functions times a weight at the place, ds [m].
  std::array<double, 3>
  edge_weights(const SectionMesh                           &mesh,
               const std::array<unsigned int, 3>           &nodes,
               const std::function<double(const Point2 &)> &weight);
} // namespace wheelrail
