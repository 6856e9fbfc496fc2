#include <wheelrail/contact/penalty.h>

#include <cmath>

namespace wheelrail
{
  Penalty
  make_penalty(const double scale,
               const double bulk_modulus,
               const double cell_size,
               const double damping_ratio,
               const double step)
  {
    const double limit = 2 * (std::sqrt(1 + damping_ratio * damping_ratio) - damping_ratio);
    Penalty      penalty;
    penalty.stiffness  = scale * bulk_modulus / cell_size;
    penalty.added_mass = 2 * penalty.stiffness * std::pow(step / limit, 2);
    penalty.damping    = 2 * damping_ratio * std::sqrt(penalty.stiffness * penalty.added_mass / 2);
    return penalty;
  }


  void
  add_surface_mass(const Surface &surface, const double added_mass, double *mass)
  {
    for (std::size_t k = 0; k < surface.reference.size(); ++k)
      if (surface.local[k] >= 0)
        mass[surface.local[k]] = added_mass * surface.area[k];
  }
} // namespace wheelrail
