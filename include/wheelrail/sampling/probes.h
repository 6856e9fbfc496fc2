#pragma once

#include <wheelrail/solid/solid.h>
#include <wheelrail/solid/stress_recovery.h>

#include <array>
#include <vector>

namespace wheelrail
{
  /// What can be probed in the bodies of a rank.
  struct ProbeSource
  {
    const NodalStress  &nodal;          ///< see nodal_stress()
    std::vector<double> plastic_strain; ///< of each cell [1]
  };

  /// `nodal` must live as long as what is returned.
  ProbeSource
  probe_source(const Solid &solid, const NodalStress &nodal);

  /// xx, yy, zz, yz, xz, xy of Cauchy's stress [Pa], accumulated plastic strain [1].
  constexpr unsigned int probe_fields = 7;

  /// Values at points [m] of the current positions of a body: stresses interpolated in the cell from values
  /// and gradients at its nodes, the plastic strain of the cell; the mean where cells meet, NaN outside of
  /// the body. All ranks pass the same points and get the same values. Collective.
  std::vector<std::array<double, probe_fields>>
  probe_body(const Solid                &solid,
             Body                        body,
             const ProbeSource          &source,
             const std::vector<Vector3> &points,
             MPI_Comm                    communicator);
} // namespace wheelrail
