#pragma once

#include <complex>
#include <vector>

namespace wheelrail
{
  /// Damping of a spring with the stiffness 1 at rest. Its dynamic stiffness at the angular frequency w is
  ///
  ///     1 + i w damper + sum over branches of share i w time / (1 + i w time).
  struct PadDamping
  {
    /// A spring and a damper behind one another (Maxwell), beside the spring.
    struct Branch
    {
      double share; ///< stiffness of its spring over that at rest
      double time;  ///< of relaxation: damper over spring [s]
    };

    double              damper = 0; ///< over the stiffness at rest [s]
    std::vector<Branch> branches;

    /// At the angular frequency [rad/s]; one with a negative imaginary part belongs to motions that fade.
    std::complex<double>
    dynamic_stiffness(std::complex<double> angular_frequency) const;

    /// Of motions too fast for the branches to relax: 1 + sum of the shares.
    double
    highest_stiffness() const;
  };

  /// One damper beside the spring, whose loss factor is `loss_factor` at `frequency` [Hz] and grows in
  /// proportion to it.
  PadDamping
  matched_damper(double loss_factor, double frequency);

  /// Lowest and highest frequency between which constant_loss() keeps its loss factor [Hz].
  constexpr double constant_loss_from = 100, constant_loss_to = 2000;

  /// Three branches that keep the loss factor constant: relaxation at 83, 500 and 3000 Hz, shares by least
  /// squares of Im - loss factor x Re. Causality (Kramers 1927, Kronig 1926) then stiffens the spring with
  /// frequency: with 0.25 by 18 % from 449 to 1261 Hz.
  PadDamping
  constant_loss(double loss_factor);
} // namespace wheelrail
