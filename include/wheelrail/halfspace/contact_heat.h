#pragma once

#include <array>
#include <vector>

namespace wheelrail
{
  struct HalfspaceGrid;
  struct HalfspaceProblem;
  struct HalfspaceSolution;
  struct TangentialState;

  /// How the bodies of a rolling contact take up heat, which flows into their depth alone (Ertz and Knothe
  /// 2002).
  struct HeatConduction
  {
    std::array<double, 2> far{{0, 0}}; ///< temperature of bodies 1 and 2 before they touch [deg C]
    /// Square root of conductivity times density times heat capacity [W s^(1/2) / (m^2 K)].
    std::array<double, 2> effusivity{{0, 0}};
    double                plastic_share = 1; ///< of the work of a layer that yields, which becomes heat
  };

  /// How friction changes with the temperature of the contact: on a line from nothing at `from` to `change`
  /// at `from + range` and beyond.
  struct FrictionOfTemperature
  {
    double from = 0, range = 1; ///< [deg C], [K]
    double change = 0;

    double
    at(double temperature) const;
  };

  /// Temperatures of the surfaces of bodies 1 and 2 in steady rolling towards +x at a velocity [m/s], per
  /// element [deg C]. In the contact both are one: where they meet, the mean of their own weighted by
  /// effusivity, and what the heat of friction [W/m^2] of all elements ahead adds (Carslaw and Jaeger 1959);
  /// the element's own counts twice, as in CONTACT. Behind it each goes back to its own.
  std::array<std::vector<double>, 2>
  surface_temperatures(const HeatConduction      &bodies,
                       const HalfspaceGrid       &grid,
                       double                     velocity,
                       const std::vector<double> &pressure,
                       const std::vector<double> &heat);

  /// The same under the tractions and the slip of a tangential solution.
  std::array<std::vector<double>, 2>
  temperatures_in_rolling(const HalfspaceProblem    &problem,
                          const std::vector<double> &pressure,
                          const TangentialState     &tangential);

  /// The largest in the contact [deg C]; NaN without temperatures.
  double
  hottest(const HalfspaceSolution &solution);
} // namespace wheelrail
