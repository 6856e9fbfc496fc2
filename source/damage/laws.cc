#include <wheelrail/damage/laws.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace wheelrail
{
  double
  usfd_wear_rate(const double t_gamma_over_area)
  {
    // Braghin, Lewis, Dwyer-Joyce and Bruni (2006), R8T on 900A: mild, severe, catastrophic wear
    constexpr double mild = 5.3, first = 10.4, plateau = 55.0, second = 77.2, severe = 61.9,
                     offset     = 4778.7; // ug/(m mm2) over N/mm2
    constexpr double micrograms = 1e-3;   // kg/m3
    const double     t          = 1e-6 * t_gamma_over_area;
    if (std::isnan(t)) // a wheel that spins up slides as fast as it likes
      return t;
    if (t < first)
      return micrograms * std::min(mild * t, plateau);
    if (t < second)
      return micrograms * plateau;
    return micrograms * std::max(plateau, severe * t - offset);
  }


  double
  burstow_damage(const double t_gamma, const WearData &data)
  {
    if (t_gamma <= data.damage_begins || t_gamma >= data.damage_ends)
      return 0;
    // Burstow (2004): up to the peak cracks grow, beyond it wear takes them away
    return data.damage_most * (t_gamma < data.damage_peak
                                 ? (t_gamma - data.damage_begins) / (data.damage_peak - data.damage_begins)
                                 : (data.damage_ends - t_gamma) / (data.damage_ends - data.damage_peak));
  }


  double
  crack_growth(const double t_gamma, const WearData &data)
  {
    return t_gamma >= data.damage_peak ? data.damage_most : burstow_damage(t_gamma, data);
  }


  double
  fatigue_index(const double traction, const double shear_yield, const double peak_pressure)
  {
    // mu - k / p0 (Ekberg, Kabo and Andersson 2002)
    return traction - shear_yield / peak_pressure;
  }


  double
  shakedown_limit(const double traction)
  {
    constexpr double step     = 0.05; // of the traction
    constexpr double limits[] = {
      4.000, 3.772, 3.564, 3.375, 3.202, 3.044, 2.900, 2.615, 2.316, 2.077, 1.882, 1.720, 1.583};
    constexpr int last  = std::size(limits) - 1;
    const double  place = std::abs(traction) / step;
    if (place >= last)
      return limits[last] * last / place; // the shear traction of the surface
    const int k = static_cast<int>(place);
    return limits[k] + (place - k) * (limits[k + 1] - limits[k]);
  }


  double
  archard_coefficient(const double slip_velocity, const double pressure, const WearData &data)
  {
    if (std::isfinite(data.archard))
      return data.archard;
    // the fields of the map of KTH (Jendel 2002): seizure, then mild and severe wear over the slip velocity
    if (pressure > 0.8 * data.hardness)
      return 350e-4;
    return slip_velocity < 0.2 || slip_velocity > 0.7 ? 5e-4 : 35e-4;
  }
} // namespace wheelrail
