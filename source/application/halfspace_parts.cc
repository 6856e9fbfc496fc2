#include <wheelrail/application/halfspace_parts.h>

namespace wheelrail
{
  HalfspaceBody
  halfspace_body(const MaterialData &material)
  {
    return {material.youngs_modulus / (2 * (1 + material.poissons_ratio)), material.poissons_ratio};
  }

  HalfspaceFriction
  halfspace_friction(const Scene &scene)
  {
    HalfspaceFriction friction;
    friction.static_coefficient  = scene.friction_coefficient;
    friction.kinetic_coefficient = scene.dynamic_friction_coefficient;
    if (scene.friction_law == FrictionKind::exponential && scene.friction_decay > 0)
      {
        friction.law            = HalfspaceFriction::Law::exponential;
        friction.velocity_scale = 1 / scene.friction_decay;
      }
    else if (scene.friction_law == FrictionKind::rational)
      {
        friction.law            = HalfspaceFriction::Law::rational;
        friction.velocity_scale = scene.friction_half_velocity;
      }
    return friction;
  }


  PatchFields
  halfspace_patch(const HalfspaceSolution &solution)
  {
    const HalfspaceGrid &grid = solution.grid;
    PatchFields          patch;
    patch.n_along   = grid.mx;
    patch.n_lateral = grid.my;
    for (int i = 0; i < grid.mx; ++i)
      for (int j = 0; j < grid.my; ++j)
        {
          const std::size_t e = i + std::size_t(grid.mx) * j;
          patch.along.push_back(grid.x(i));
          patch.lateral.push_back(grid.y(j));
          patch.gap.push_back(solution.gap[e]);
          patch.pressure.push_back(solution.pressure[e]);
          patch.shear_along.push_back(solution.traction_x[e]);
          patch.shear_lateral.push_back(solution.traction_y[e]);
          patch.slip_along.push_back(-solution.slip_x[e]);
          patch.slip_lateral.push_back(-solution.slip_y[e]);
          patch.state.push_back(solution.state[e]);
          patch.area.push_back(grid.element_area());
        }
    return patch;
  }
} // namespace wheelrail
