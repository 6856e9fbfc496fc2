#pragma once

#include <wheelrail/material/cyclic_hardening.h>

#include <cmath>
#include <limits>
#include <string>

namespace wheelrail
{
  /// How steel answers beyond yield.
  enum class SteelLaw
  {
    elastic,  ///< it does not yield
    bilinear, ///< linear hardening; elastic while there is no yield stress
    chaboche  ///< cyclic hardening
  };

  /// Steel [SI].
  struct MaterialData
  {
    SteelLaw    law                 = SteelLaw::bilinear;
    double      youngs_modulus      = 210e9;
    double      poissons_ratio      = 0.3;
    double      density             = 7900;
    double      yield_stress        = std::numeric_limits<double>::infinity(); ///< infinite: elastic
    double      tangent_modulus     = 21e9;
    double      kinematic_hardening = 0;     ///< fraction, 0 isotropic, 1 kinematic
    std::string steel               = "any"; ///< by which elastic results are judged, see scene/steels.h
    /// Of the law of Chaboche; its yield stress is the one above.
    CyclicHardening cyclic;

    /// Whether the steel may yield.
    bool
    yields() const
    {
      return law != SteelLaw::elastic && std::isfinite(yield_stress);
    }
  };

  /// The steels of rail and wheel, as in subsections Rail material and Wheel material.
  struct SteelSettings
  {
    MaterialData rail_material, wheel_material;
  };
} // namespace wheelrail
