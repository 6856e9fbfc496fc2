#pragma once

#include <wheelrail/model/model.h>
#include <wheelrail/sampling/slices.h>
#include <wheelrail/wheelset/axle.h>

#include <vector>

namespace wheelrail
{
  /// What a passage leaves in the bodies once all loads are taken off.
  struct Residual
  {
    NodalStress stress; ///< recovered at the nodes of the rank
    /// AA_behind and BB_behind (slices_behind()) of the rail that the patch has left; with a start farther
    /// along the rail BB_behind is at the same place of the rail as without.
    std::vector<Slice> slices;
    double largest; ///< von Mises, of elements of that rail that have flowed [Pa]; NaN without one
    double forward; ///< displacement of that rail along Z that is the largest in size, where all was rolled
                    ///< over [m]
  };

  /// Measures it in bodies without loads (WhileUnloaded) on the mesh of a discretization. Collective.
  Residual
  residual_of(const Model &model, const Axle &axle, MPI_Comm communicator);
} // namespace wheelrail
