#include <wheelrail/scene/rail_bending.h>

#include <cmath>

namespace wheelrail
{
  RailBending
  rail_bending(const SupportData &support)
  {
    constexpr double EI       = 5.5e6; // 54E1 4.9, 60E1 6.4 MN m2
    double           of_place = support.pad_stiffness;
    if (support.kind == RailSupport::sleepers && std::isfinite(support.sleeper_mass))
      of_place *= support.ballast_stiffness / (of_place + support.ballast_stiffness);
    RailBending bending;
    bending.foundation = of_place / support.spacing;
    bending.length     = std::pow(4 * EI / bending.foundation, 0.25);
    bending.deflection = 1 / (2 * bending.foundation * bending.length);
    return bending;
  }


  double
  enough_rail(const Scene &scene)
  {
    return 2 * 2 * rail_bending(scene.support).length + scene.mesh_distance();
  }
} // namespace wheelrail
