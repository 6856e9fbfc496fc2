#pragma once

#include <wheelrail/base/body.h>
#include <wheelrail/geometry/running_surfaces.h>
#include <wheelrail/solid/solid.h>
#include <wheelrail/solid/stress_recovery.h>

namespace wheelrail
{
  /// What plastic flow left behind, over all ranks; NaN where there is nothing.
  struct PlasticFigures
  {
    double          max_strain; ///< largest accumulated plastic strain of both bodies; NaN: both elastic [1]
    PerBody<double> work;       ///< plastic work [J]
    double          band_width; ///< lateral extent of the rail's nodes above band_strain, along s [m]
    double band_depth;  ///< of the deepest of them below the undeformed surface, along the contact normal [m]
    double band_centre; ///< middle of that extent, s [m]
  };

  /// The accumulated plastic strain from which steel counts as belonging to the band that flowed [1].
  constexpr double band_strain = 1e-4;

  /// Of the bodies now. Collective.
  PlasticFigures
  plastic_figures(const Solid &solid, const RunningSurfaces &surfaces, MPI_Comm communicator);

  /// Largest accumulated plastic strain over the elements of all ranks; NaN: both bodies are elastic [1].
  /// Collective.
  double
  largest_plastic_strain(const Solid &solid, MPI_Comm communicator);

  /// Largest von Mises stress over the elements of all ranks [Pa]. Collective.
  double
  largest_von_mises(const Solid &solid, MPI_Comm communicator);

  /// Largest von Mises stress over the nodes of all ranks, recovered as in the VTU files (nodal_stress())
  /// [Pa]. Collective.
  double
  largest_von_mises(const NodalStress &nodal, MPI_Comm communicator);
} // namespace wheelrail
