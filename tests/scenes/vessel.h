#pragma once

// Thick cylinder and thick sphere of a material without hardening under internal pressure.

#include "dynamics.h"

#include <array>
#include <cmath>

namespace scenes
{
  constexpr double inner_radius = 0.1, outer_radius = 0.2;

  /// Hill, The Mathematical Theory of Plasticity, 1950, chapter 5. k: flow stress of the difference of hoop
  /// and radial stress; n = 2 for the cylinder, 3 for the sphere.
  struct Vessel
  {
    int    n;
    double flow; ///< hoop minus radial stress in the plastic part [Pa]

    /// Pressure at which the plastic front is at c [Pa].
    double
    pressure(const double c) const
    {
      const double ratio = std::pow(c / outer_radius, n);
      return n == 2 ? flow * (std::log(c / inner_radius) + (1 - ratio) / 2)
                    : 2 * flow * std::log(c / inner_radius) + 2. / 3 * flow * (1 - ratio);
    }
    /// Radial and hoop stress at r with the front at c.
    std::array<double, 2>
    stress(const double r, const double c) const
    {
      const double b = std::pow(c / outer_radius, n);
      if (r >= c)
        {
          const double x = std::pow(outer_radius / r, n);
          return n == 2 ? std::array<double, 2>{flow / 2 * b * (1 - x), flow / 2 * b * (1 + x)}
                        : std::array<double, 2>{2. / 3 * flow * b * (1 - x), 2. / 3 * flow * b * (1 + x / 2)};
        }
      const double radial = (n == 2 ? flow : 2 * flow) * std::log(r / inner_radius) - pressure(c);
      return {radial, radial + flow};
    }
    /// Elastic stresses under the pressure p (Lame).
    std::array<double, 2>
    elastic(const double r, const double p) const
    {
      const double f = p / (std::pow(outer_radius / inner_radius, n) - 1), x = std::pow(outer_radius / r, n);
      return {f * (1 - x), f * (1 + x / (n - 1))};
    }
    /// Displacement of the outer_radius surface [m].
    double
    outer_displacement(const double c, const Elasticity &m) const
    {
      const double nu = m.poissons_ratio, b = std::pow(c / outer_radius, n);
      return n == 2 ? flow * b * outer_radius * (1 - nu * nu) / m.youngs_modulus
                    : flow * b * outer_radius * (1 - nu) / m.youngs_modulus;
    }
  };

  /// What is found under load and after unloading; the errors are the largest ones of all elements [Pa].
  struct VesselState
  {
    double        front        = 0; ///< radius where the plastic strain vanishes [m]
    double        displacement = 0; ///< of the outer surface [m]
    double        radial = 0, hoop = 0, residual = 0;
    EnergyBalance energy;
  };

  /// Loads to the front c and unloads, slowly. The mesh is a quarter of the tube or an octant of the sphere
  /// between the radii above.
  VesselState
  load_vessel(Setup setup, const Vessel &vessel, LocalMesh mesh, double c);
} // namespace scenes
