#pragma once

#include <limits>
#include <string>

namespace wheelrail
{
  /// Which bodies change their profile.
  enum class WornBody
  {
    rail,
    wheel,
    both
  };

  /// How far profiles wear, and under what.
  struct WearPlan
  {
    static constexpr double automatic = std::numeric_limits<double>::infinity();

    std::string  mix         = "none"; ///< table of the scenes that share the traffic, or the scene alone
    WornBody     worn        = WornBody::rail;
    double       gross_load  = 10e9;      ///< that passes the rail [kg]
    double       distance    = 100e6;     ///< that the wheel rolls, where it wears alone [m]
    double       smoothing   = 10e-3;     ///< cut-off wavelength of the worn depth [m]
    double       step_depth  = automatic; ///< most that one step takes off [m]
    double       line_length = 1000;      ///< of the rail that the wheels share, where both wear [m]
    unsigned int wheels      = 100;       ///< that share it
    std::string  grind_to    = "none";    ///< profile that the rail is ground to
    double       grind_every = 5e9;       ///< gross load between two grindings [kg]
    std::string  turn_to     = "none";    ///< profile that the wheel is turned to
    double       turn_every  = 100e6;     ///< distance between two turnings [m]
  };
} // namespace wheelrail
