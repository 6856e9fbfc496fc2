#include <wheelrail/model/scene_material.h>

#include <algorithm>
#include <cmath>

namespace wheelrail
{
  Elasticity
  elasticity(const MaterialData &material)
  {
    return {material.youngs_modulus, material.poissons_ratio, material.density};
  }


  double
  highest_frequency(const Scene &scene)
  {
    if (!scene.mass_scaling)
      return HUGE_VAL;
    const double speed =
      std::max(elasticity(scene.rail_material).wave_speed(), elasticity(scene.wheel_material).wave_speed());
    return std::pow(2 * speed / scene.cell_size, 2);
  }


  double
  mean_bulk_modulus(const SteelSettings &scene)
  {
    return 0.5 *
           (elasticity(scene.rail_material).bulk_modulus() + elasticity(scene.wheel_material).bulk_modulus());
  }


  MaterialLaw
  material_law(const MaterialData &material)
  {
    if (!material.yields())
      return ElasticLaw(elasticity(material));
    if (material.law == SteelLaw::chaboche)
      {
        CyclicHardening hardening = material.cyclic;
        hardening.yield_stress    = material.yield_stress;
        return ChabocheLaw(elasticity(material), hardening);
      }
    return BilinearLaw(elasticity(material),
                       {material.yield_stress, material.tangent_modulus, material.kinematic_hardening});
  }
} // namespace wheelrail
