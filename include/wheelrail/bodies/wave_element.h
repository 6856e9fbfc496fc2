#pragma once

#include <wheelrail/bodies/section_mesh.h>
#include <wheelrail/material/elasticity.h>

#include <array>

// The 2.5-D element of WaveStiffness: nine nodes, three displacements each (x, y, w).

namespace wheelrail
{
  constexpr unsigned int n_wave_nodes = 9, n_wave_local = 3 * n_wave_nodes;

  /// Gauss points of three on [0, 1], and their weights.
  constexpr double wave_gauss_place[3]  = {0.1127016653792583, 0.5, 0.8872983346207417};
  constexpr double wave_gauss_weight[3] = {5. / 18, 8. / 18, 5. / 18};

  /// At one of the nine points of a cell: shape functions, their derivatives along x and y, the place and its
  /// weight.
  struct WavePoint
  {
    std::array<double, n_wave_nodes> value, dx, dy;
    Point2                           place;
    double                           weight = 0; ///< area [m2]
  };

  /// Throws RunError where the cell is folded.
  WavePoint
  wave_point(const SectionMesh &mesh, const std::array<unsigned int, n_wave_nodes> &cell, int number);

  using WaveMatrix = std::array<std::array<double, n_wave_local>, n_wave_local>;

  /// K0, K1, K2 and the mass M of a cell: of a rail for each metre, of a wheel for each radian.
  std::array<WaveMatrix, 4>
  wave_matrices(const SectionMesh                            &mesh,
                const std::array<unsigned int, n_wave_nodes> &cell,
                const Elasticity                             &elasticity,
                bool                                          wheel);
} // namespace wheelrail
