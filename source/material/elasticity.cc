#include <wheelrail/material/elasticity.h>

#include <cmath>

namespace wheelrail
{
  double
  Elasticity::wave_speed() const
  {
    return std::sqrt((lame_lambda() + 2 * shear_modulus()) / density);
  }
} // namespace wheelrail
