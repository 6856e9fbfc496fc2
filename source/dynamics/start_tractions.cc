#include <wheelrail/dynamics/start_tractions.h>

#include <algorithm>
#include <cmath>

namespace wheelrail
{
  namespace
  {
    /// Half lengths of the loaded nodes' hull and FASTSIM's flexibility.
    struct Patch
    {
      double half_along = 0, half_across = 0;
    };

    Patch
    loaded_patch(const Contact &contact)
    {
      const Lattice &lattice = contact.lattice();
      int            i0 = lattice.n_along, i1 = -1, j0 = lattice.n_lateral, j1 = -1;
      for (unsigned int i = 0; i < lattice.n_along; ++i)
        for (unsigned int j = 0; j < lattice.n_lateral; ++j)
          if (contact.nodes()[lattice.index(i, j)].pressure > 0)
            {
              i0 = std::min<int>(i0, i), i1 = std::max<int>(i1, i);
              j0 = std::min<int>(j0, j), j1 = std::max<int>(j1, j);
            }
      if (i1 < i0)
        return {};
      return {0.5 * (i1 - i0 + 1) * lattice.spacing_along, 0.5 * (j1 - j0 + 1) * lattice.spacing_lateral};
    }
  } // namespace


  double
  creepage_coefficient(const double ratio)
  {
    // logarithm of a/b against C11 at Poisson's ratio 0.3
    constexpr double a_over_b[] = {
      0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1.0, 1.25, 1 / 0.6, 2.5, 5, 10};
    constexpr double C11[] = {3.535,
                              3.585,
                              3.647,
                              3.730,
                              3.813,
                              3.911,
                              3.996,
                              4.095,
                              4.192,
                              4.300,
                              4.537,
                              4.955,
                              5.744,
                              7.968,
                              11.92};
    constexpr int    n     = sizeof(C11) / sizeof(double);
    const double     x     = std::log(std::clamp(ratio, a_over_b[0], a_over_b[n - 1]));
    int              k     = 0;
    while (k < n - 2 && x > std::log(a_over_b[k + 1]))
      ++k;
    const double x0 = std::log(a_over_b[k]), x1 = std::log(a_over_b[k + 1]);
    return C11[k] + (C11[k + 1] - C11[k]) * (x - x0) / (x1 - x0);
  }


  StartTractions
  start_tractions_at_creepage(const Contact &contact, const double creepage, const double shear_modulus)
  {
    const Lattice &lattice = contact.lattice();
    StartTractions result;
    result.creepage = creepage;
    result.shear.assign(contact.nodes().size(), {0, 0, 0});
    const Patch patch = loaded_patch(contact);
    if (patch.half_along == 0)
      return result;
    const double flexibility =
      8 * patch.half_along / (3 * creepage_coefficient(patch.half_along / patch.half_across) * shear_modulus);
    const RunningSurfaces &surfaces = contact.surfaces();
    const double           growth   = lattice.spacing_along / flexibility;
    for (unsigned int j = 0; j < lattice.n_lateral; ++j)
      {
        const double s      = lattice.s_begin + j * lattice.spacing_lateral;
        const double radius = surfaces.local_radius(s);
        const double turn   = (1 + creepage) / surfaces.rolling_radius; // omega / V
        const double angle  = surfaces.frame.angle + std::atan(surfaces.wheel.at(s).slope);
        double       along = 0, lateral = 0;
        for (int i = lattice.n_along - 1; i >= 0; --i)
          {
            // slip of the wheel's surface against the rail over V: it runs backwards when the wheel
            // drives, and ahead of the axle it still descends, which slides it along its inclination
            const double z = (lattice.first_station + i) * lattice.spacing_along;
            along += growth * (1 - turn * radius);
            lateral -= growth * turn * z * std::sin(angle);
            const std::size_t k     = lattice.index(i, j);
            const double      bound = contact.law().friction.at_rest * contact.nodes()[k].pressure;
            const double      size  = std::hypot(along, lateral);
            if (size > bound)
              {
                along *= bound / size;
                lateral *= bound / size;
              }
            result.shear[k] = {lateral * std::cos(angle), lateral * std::sin(angle), along};
            result.force -= along * contact.rail().area[k];
          }
      }
    return result;
  }


  StartTractions
  start_tractions(const Contact &contact, const double longitudinal_force, const double shear_modulus)
  {
    // the last two per cent below full slip cost any creepage; a torque beyond them spins the wheel up
    constexpr double limit = 0.1, full_slip = 0.98;
    double           bound = 0;
    for (std::size_t k = 0; k < contact.nodes().size(); ++k)
      bound += full_slip * contact.law().friction.at_rest * contact.nodes()[k].pressure * contact.rail().area[k];
    const double wanted = std::clamp(longitudinal_force, -bound, bound);
    double       low = -limit, high = limit;
    for (int k = 0; k < 60; ++k)
      {
        const double middle = 0.5 * (low + high);
        if (start_tractions_at_creepage(contact, middle, shear_modulus).force < wanted)
          low = middle;
        else
          high = middle;
      }
    StartTractions result = start_tractions_at_creepage(contact, 0.5 * (low + high), shear_modulus);
    result.saturated = std::abs(result.force - longitudinal_force) > 0.01 * std::abs(longitudinal_force) + 1;
    return result;
  }
} // namespace wheelrail
