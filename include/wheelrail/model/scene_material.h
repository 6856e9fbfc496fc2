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

  /// The squared frequency above which Mesh/Mass scaling holds cells, that of a cube of the solution cell
  /// size h of the steel with the faster pressure waves, (2 c/h)^2; infinitely large without [1/s2].
  double
  highest_frequency(const Scene &scene);

  /// Mean bulk modulus of rail and wheel [Pa], which the penalty law is made of (make_law()).
  double
  mean_bulk_modulus(const SteelSettings &scene);
} // namespace wheelrail
