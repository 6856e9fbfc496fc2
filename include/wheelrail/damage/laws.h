#pragma once

#include <limits>

namespace wheelrail
{
  /// What wear and crack laws need beside the contact; defaults are those of their sources.
  struct WearData
  {
    static constexpr double automatic = std::numeric_limits<double>::infinity();

    double archard     = automatic; ///< coefficient k [1]; automatic: archard_coefficient()
    double hardness    = 2.55e9;    ///< of the softer steel, 260 HB [Pa]
    double shear_yield = automatic; ///< k of the rail's surface [Pa]; automatic: from its yield stress

    // Damage function for cracks (Burstow 2004), over T-gamma
    double damage_begins = 15;   ///< [N]
    double damage_peak   = 65;   ///< [N]
    double damage_ends   = 175;  ///< [N]
    double damage_most   = 1e-5; ///< share of a life at the peak, for each passage [1]
    double crack_depth   = 1e-3; ///< that wear or grinding has to take off for a damage of 1 [m]
  };

  /// Wear of a wheel of R8T steel on a rail of steel 900A, as mass for each metre rolled and area of the
  /// contact [kg/m3 = 1e3 ug/(m mm2)], over T-gamma for each area of the contact [N/m2]: 5.3 T/A below 10.4
  /// N/mm2, 55.0 up to 77.2, then 61.9 T/A - 4778.7 ug/(m mm2) (twin-disc tests of the University of
  /// Sheffield; Braghin, Lewis, Dwyer-Joyce, Bruni 2006). The source's last branch begins at 0: here the
  /// plateau holds on until the branch has reached it, at 78.1 N/mm2.
  double
  usfd_wear_rate(double t_gamma_over_area);

  /// Share of the life until a crack that one passage takes (Burstow 2004), over T-gamma [N]: nothing below
  /// damage_begins, rising on a line to damage_most at damage_peak, falling to nothing at damage_ends, from
  /// where on wear takes cracks away.
  double
  burstow_damage(double t_gamma, const WearData &data);

  /// The same without what wear takes: rising to damage_most at damage_peak, where it stays. Of a crack that
  /// is crack_depth deep at a damage of 1, wear has to be counted off beside it.
  double
  crack_growth(double t_gamma, const WearData &data);

  /// Fatigue index of the surface (Ekberg, Kabo, Andersson 2002), mu - k / p0, with the traction over the
  /// normal force mu, the yield stress in shear k and the peak pressure p0 [Pa]; 2 pi a b k / (3 F) of a
  /// Hertzian patch is k / p0. The surface is predicted to fatigue where it is positive.
  double
  fatigue_index(double traction, double shear_yield, double peak_pressure);

  /// Limit of shakedown of line contact with full slip, peak pressure over yield stress in shear, over the
  /// traction (Melan's theorem; Johnson 1985, section 9.2; source/report/shakedown.py draws it): 4.0 without
  /// traction. Contacts that are as wide as long bear up to 4.7 (Ponter, Hearle, Johnson 1985).
  double
  shakedown_limit(double traction);

  /// Archard's coefficient over slip velocity [m/s] and pressure [Pa] (KTH; Jendel 2002), the middle of each
  /// field: 5e-4 below 0.2 m/s and above 0.7 m/s, 35e-4 between, 350e-4 where the pressure exceeds 0.8 of the
  /// hardness; or the one that is given.
  double
  archard_coefficient(double slip_velocity, double pressure, const WearData &data);
} // namespace wheelrail
