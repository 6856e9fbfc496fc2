#pragma once

#include <wheelrail/solid/solid.h>
#include <wheelrail/solid/stress_recovery.h>

#include <array>
#include <vector>

namespace wheelrail
{
  /// Places in a body at which its fields are wanted, and what a rank has of them.
  struct Probes
  {
    /// A cell of this rank that holds a point.
    struct Hit
    {
      std::size_t  point; ///< number of the point, 0 ... n_points - 1
      unsigned int cell;  ///< see LocalMesh::cells
      Vector3      xi;    ///< place in the unit cube that the cell's map takes to its corners, 0 ... 1
    };

    std::size_t      n_points = 0;
    std::vector<Hit> hits; ///< none for a point outside, several where cells meet
    MPI_Comm         communicator;
  };

  /// Finds points [m] among the current positions of a body. All ranks pass the same points, here and so
  /// below.
  Probes
  find_probes(const Solid &solid, Body body, const std::vector<Vector3> &points, MPI_Comm communicator);

  /// Cauchy's stress xx, yy, zz, yz, xz, xy [Pa] at the points, from values and gradients at the nodes
  /// (nodal_stress()); as the other fields the mean where cells meet and NaN outside of the body, the same
  /// on all ranks. Collective.
  std::vector<std::array<double, 6>>
  probe_stress(const Probes &probes, const LocalMesh &mesh, const NodalStress &nodal);

  /// A field of one number a node, interpolated linearly, in its own unit. Collective.
  std::vector<double>
  probe_nodes(const Probes &probes, const LocalMesh &mesh, const std::vector<double> &field);

  /// A field of one number a cell, in its own unit. Collective.
  std::vector<double>
  probe_cells(const Probes &probes, const std::vector<double> &field);
} // namespace wheelrail
