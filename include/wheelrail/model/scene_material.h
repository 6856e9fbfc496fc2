#pragma once

#include <wheelrail/material/material_law.h>
#include <wheelrail/scene/scene.h>

namespace wheelrail
{
  /// Elastic constants of an input block.
  Elasticity
  elasticity(const MaterialData &material);

  /// Its material law.
  MaterialLaw
  material_law(const MaterialData &material);

  /// Mean bulk modulus of rail and wheel [Pa], which the penalty law is made of (make_law()).
  double
  mean_bulk_modulus(const SteelSettings &scene);
} // namespace wheelrail
