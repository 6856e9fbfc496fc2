#pragma once

namespace wheelrail
{
  /// How the friction coefficient depends on the slip velocity v.
  enum class FrictionKind
  {
    constant,    ///< mu = mu_s
    exponential, ///< mu = mu_d + (mu_s - mu_d) exp(-c v), the law of many explicit codes
    rational,    ///< mu = mu_d + (mu_s - mu_d) / (1 + v / v_h), as in Kalker's program CONTACT
    linear       ///< mu = mu_d + (mu_s - mu_d) max(0, 1 - v / (2 v_h)), in files of that program only
  };

  /// A friction law with its constants, which its users do not read: they ask for the coefficient.
  struct FrictionLaw
  {
    double       at_rest       = 0; ///< mu_s; the only one of a constant law
    FrictionKind kind          = FrictionKind::constant;
    double       at_speed      = 0; ///< mu_d, far beyond the decay; may exceed mu_s
    double       decay         = 0; ///< c of the exponential law [s/m]
    double       half_velocity = 1; ///< v_h, at which half of mu_s - mu_d is gone (rational, linear) [m/s]
    /// A second term of CONTACT's laws, a part of mu_s - mu_d: half of it is gone at second_velocity [m/s],
    /// as 2^(-v / v_2) (exponential), 1 / (1 + (v / v_2)^2) (rational) or 1 - v / (2 v_2) (linear).
    double second_drop = 0, second_velocity = 1;

    /// Friction coefficient at the slip velocity `speed` >= 0 [m/s].
    double
    at(double speed) const;

    /// The largest of all speeds.
    double
    largest() const;

    /// Coefficient of fast sliding, far beyond the decay.
    double
    sliding() const;

    /// The same law with another coefficient at rest; one that changes with speed keeps its shape.
    FrictionLaw
    with_rest(double coefficient) const;

    /// No constant is negative, and the half velocity is positive.
    bool
    valid() const;

    /// The coefficient changes with the slip velocity.
    bool
    depends_on_speed() const;

    /// Steepest fall of the coefficient with speed, at rest [s/m]; 0 where it is constant or rises.
    double
    steepest_fall() const;

    /// No speed has a coefficient above 0.
    bool
    frictionless() const;
  };
} // namespace wheelrail
