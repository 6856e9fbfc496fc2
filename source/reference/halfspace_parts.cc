#include <wheelrail/base/errors.h>
#include <wheelrail/reference/halfspace_parts.h>

namespace wheelrail
{
  namespace
  {
    HalfspaceBody
    halfspace_body(const MaterialData &material)
    {
      return {material.youngs_modulus / (2 * (1 + material.poissons_ratio)), material.poissons_ratio};
    }
  } // namespace


  HalfspaceProblem
  halfspace_problem(const Scene &scene)
  {
    HalfspaceProblem problem;
    problem.body1    = halfspace_body(scene.rail_material);
    problem.body2    = halfspace_body(scene.wheel_material);
    problem.friction = friction_law(scene);
    problem.velocity = scene.velocity;
    return problem;
  }


  HalfspaceSolution
  solve_on_growing_grid(HalfspaceProblem                  &problem,
                        double                             approach,
                        const int                          most,
                        const std::function<void(double)> &lay_grid,
                        int                               &enlargements)
  {
    problem.motion = HalfspaceMotion::none;
    // extents go with the root of the approach: each grid is a fifth longer and wider than the last
    for (enlargements = 0;; ++enlargements, approach *= 1.5)
      {
        lay_grid(approach);
        const HalfspaceSolution solution = solve_rolling(problem);
        if (!solution.touches_grid_edge || enlargements == most)
          return solution;
      }
  }


  HalfspaceSolution
  solve_carried(const HalfspaceProblem &problem)
  {
    HalfspaceSolution solution = solve_rolling(problem);
    if (!solution.within_friction)
      throw InputError("Half-space problem: " +
                       solution.not_reached.substr(0, solution.not_reached.find_last_not_of(' ') + 1));
    return solution;
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
          patch.traction_along.push_back(solution.traction_x[e]);
          patch.traction_lateral.push_back(solution.traction_y[e]);
          patch.slip_along.push_back(-solution.slip_x[e]);
          patch.slip_lateral.push_back(-solution.slip_y[e]);
          patch.state.push_back(solution.state[e]);
          patch.area.push_back(grid.element_area());
        }
    return patch;
  }
} // namespace wheelrail
