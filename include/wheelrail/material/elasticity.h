#pragma once

namespace wheelrail
{
  /// Linear elastic constants [SI]; without further word those of the steel that the checks of this program
  /// are made with (doc/theory/verification.md).
  struct Elasticity
  {
    double youngs_modulus = 210e9;
    double poissons_ratio = 0.3;
    double density        = 7900;

    double
    lame_lambda() const
    {
      return youngs_modulus * poissons_ratio / ((1 + poissons_ratio) * (1 - 2 * poissons_ratio));
    }
    double
    shear_modulus() const
    {
      return youngs_modulus / (2 * (1 + poissons_ratio));
    }
    double
    bulk_modulus() const
    {
      return youngs_modulus / (3 * (1 - 2 * poissons_ratio));
    }
    /// Speed of pressure waves [m/s].
    double
    wave_speed() const;
  };
} // namespace wheelrail
