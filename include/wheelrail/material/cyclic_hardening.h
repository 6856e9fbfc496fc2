#pragma once

#include <vector>

namespace wheelrail
{
  /// Most back stresses that a steel of Chaboche's kind may have.
  constexpr int most_back_stresses = 8;

  /// Constants of Chaboche's steel: isotropic hardening R with dR = b (Q - R) dp, and back stresses of
  /// Armstrong and Frederick with dX = 2/3 C dE_p - gamma X dp, each bounded by C / gamma.
  struct CyclicHardening
  {
    double              yield_stress   = 0; ///< initial [Pa]
    double              isotropic      = 0; ///< Q, negative in steel that softens [Pa]
    double              isotropic_rate = 0; ///< b [1]
    std::vector<double> moduli;             ///< C of each back stress [Pa]
    std::vector<double> rates;              ///< gamma of each back stress, as many [1]
    /// Share of the recovery gamma X dp that acts below the threshold C / gamma, too: 1 Armstrong and
    /// Frederick, 0 Ohno and Wang, between them Abdel-Karim and Ohno (2000).
    double recovery = 1;
  };
} // namespace wheelrail
