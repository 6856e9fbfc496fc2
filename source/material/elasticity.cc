#include <wheelrail/material/elasticity.h>

#include <cmath>

namespace wheelrail
{
  double
  Elasticity::wave_speed() const
  {
    // speed of pressure waves in an endless body, c_p = sqrt((lambda + 2 mu)/rho) [m/s]; 5982 m/s in steel
    // (doc/theory/verification.md). The stable step of cubes is h/c_p.
    return std::sqrt((lame_lambda() + 2 * shear_modulus()) / density);
  }
} // namespace wheelrail
