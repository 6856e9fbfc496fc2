#pragma once

#include <wheelrail/solid/kernel.h>

namespace wheelrail
{
  /// As subtract_internal_force, for elements of the form `reduced`.
  void
  subtract_reduced_force(ElementBlocks       &blocks,
                         const double        *displacement,
                         double              *force,
                         const BulkViscosity &viscosity,
                         bool                 with_energy,
                         ElementEnergy       &energy);
} // namespace wheelrail
