#include <wheelrail/material/chaboche_equation.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

// Constants of the one equation for dp of an implicit step (Kobayashi and Ohno 2002; doc/manual/material.md,
// Cyclic hardening), G the shear modulus,
//
//     f(dp) = q(dev S_trial - sum theta_i X_i) - (3 G + sum theta_i C_i) dp - sigma_y - R(dp) = 0,
//
// and bounds on its slope and its curvature, between which Newton's method is safe.

namespace wheelrail
{
  ChabocheEquation::ChabocheEquation(const Elasticity &constants, const CyclicHardening &hardening)
    : PlasticLaw(constants)
    , yield_stress(hardening.yield_stress)
    , isotropic(hardening.isotropic)
    , isotropic_rate(hardening.isotropic_rate)
    , n_back(static_cast<int>(hardening.moduli.size()))
    , bounded(hardening.recovery < 1)
    // slope of (3 mu + sum theta_i C_i) dp + R(dp): back stresses only add to it, R falls by |Q| b at most
    // where Q < 0 (cyclic softening)
    , least_slope(3 * shear + std::min(0., isotropic * isotropic_rate))
  {
    if (hardening.rates.size() != hardening.moduli.size() || n_back > most_back_stresses)
      throw std::invalid_argument("as many kinematic rates as moduli are needed, and not too many");
    double recovered = 0, moduli = 0;
    for (int i = 0; i < n_back; ++i)
      {
        // dX_i = 2/3 C_i dE_p - gamma_i X_i dp (Armstrong and Frederick); the part mu of gamma_i acts always
        // (`recovery`), the rest at the threshold q(X_i) = C_i/gamma_i alone (Abdel-Karim and Ohno 2000;
        // doc/manual/material.md, Cyclic hardening)
        const double gamma = hardening.rates[i];
        // C_i [Pa], gamma_i [-]; X_i grows to C_i/gamma_i
        modulus[i]  = hardening.moduli[i];
        recovery[i] = hardening.recovery * gamma;
        // theta_i = 1/(1 + mu gamma_i dp), mu the part that always acts, bends f by this much
        recovered += recovery[i] * modulus[i];
        moduli += modulus[i];
        threshold[i] = gamma > 0 ? modulus[i] / gamma : std::numeric_limits<double>::infinity();
      }
    // what bends: theta_i C_i dp, theta_i X_i, the direction of their sum, and R
    // a bound of half the second derivative, so that Newton's error after a step is at most curvature times
    // its square
    curvature = 2 * recovered + 0.5 * moduli * moduli / (yield_stress + std::min(0., isotropic)) +
                isotropic_rate * isotropic_rate * std::abs(isotropic);
  }
} // namespace wheelrail
