#pragma once

// The steel of the rolled strips.

#include "scenes/dynamics.h"

#include <cmath>

namespace test
{
  constexpr double strip_yield_stress = 30e6; ///< a tenth of a steel's: squares of strains do not matter [Pa]
  const double     strip_k            = strip_yield_stress / std::sqrt(3.); ///< in shear [Pa]

  /// Perfectly plastic without further word; otherwise with a tangent modulus [Pa] and its kinematic part.
  inline scenes::Setup
  strip_steel(const double tangent_modulus = 0, const double kinematic_fraction = 0)
  {
    scenes::Setup setup;
    setup.plasticity = {strip_yield_stress, tangent_modulus, kinematic_fraction};
    return setup;
  }
} // namespace test
