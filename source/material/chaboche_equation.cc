#include <wheelrail/material/chaboche_equation.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace wheelrail
{
  ChabocheEquation::ChabocheEquation(const Elasticity &constants, const CyclicHardening &hardening)
    : PlasticLaw(constants)
    , yield_stress(hardening.yield_stress)
    , isotropic(hardening.isotropic)
    , isotropic_rate(hardening.isotropic_rate)
    , n_back(static_cast<int>(hardening.moduli.size()))
    , bounded(hardening.recovery < 1)
    , least_slope(3 * shear + std::min(0., isotropic * isotropic_rate))
  {
    if (hardening.rates.size() != hardening.moduli.size() || n_back > most_back_stresses)
      throw std::invalid_argument("as many kinematic rates as moduli are needed, and not too many");
    double recovered = 0, moduli = 0;
    for (int i = 0; i < n_back; ++i)
      {
        const double gamma = hardening.rates[i];
        modulus[i]         = hardening.moduli[i];
        recovery[i]        = hardening.recovery * gamma;
        recovered += recovery[i] * modulus[i];
        moduli += modulus[i];
        threshold[i] = gamma > 0 ? modulus[i] / gamma : std::numeric_limits<double>::infinity();
      }
    // what bends: theta_i C_i dp, theta_i X_i, the direction of their sum, and R
    curvature = 2 * recovered + 0.5 * moduli * moduli / (yield_stress + std::min(0., isotropic)) +
                isotropic_rate * isotropic_rate * std::abs(isotropic);
  }
} // namespace wheelrail
