#include <wheelrail/base/quantity.h>
#include <wheelrail/halfspace/sliding_paths.h>
#include <wheelrail/model/scene_material.h>
#include <wheelrail/planes/wheel_on_rail.h>
#include <wheelrail/wheel/halfspace_parts.h>

#include <algorithm>
#include <cmath>

namespace wheelrail
{
  namespace
  {
    std::string
    counted_elements(const int n)
    {
      return std::to_string(n) + (n == 1 ? " element lies" : " elements lie");
    }
  } // namespace


  HalfspaceProblem
  halfspace_problem(const Scene &scene)
  {
    HalfspaceProblem problem = wheel_on_rail(
      {elasticity(scene.rail_material), elasticity(scene.wheel_material)}, scene.friction, scene.velocity);
    problem.memory_length      = scene.halfspace_memory_length;
    problem.memory_least_speed = scene.halfspace_memory_speed;
    problem.layer_compliance   = scene.halfspace_layer_thickness / scene.halfspace_layer_shear;
    return problem;
  }


  WheelMotion
  wheel_motion(const Scene &scene, const ContactGeometry &contact)
  {
    WheelMotion motion;
    motion.forward_radius   = contact.forward_radius;
    motion.lateral_creepage = lateral_creepage(scene);
    motion.curvature        = path_curvature(scene);
    return motion;
  }


  WheelMotion
  plane_motion(const Scene &scene, const ContactGeometry &contact)
  {
    WheelMotion motion = wheel_motion(scene, contact);
    const bool  given  = std::isfinite(scene.halfspace_given_spin);
    if (given)
      motion.spin = scene.halfspace_given_spin;
    motion.one_spin = given || scene.halfspace_spin == HalfspaceSpin::contact;
    return motion;
  }


  int
  elements_across(const HalfspaceSolution &solution)
  {
    const HalfspaceGrid &grid = solution.grid;
    const auto          &p    = solution.pressure;
    const auto           top  = std::max_element(p.begin(), p.end()) - p.begin();
    const int            i = static_cast<int>(top) % grid.mx, j = static_cast<int>(top) / grid.mx;
    const auto           count = [&](const int di, const int dj) {
      int n = 0;
      for (int a = i, b = j;
           a >= 0 && b >= 0 && a < grid.mx && b < grid.my && p[a + std::size_t(grid.mx) * b] > 0;
           a += di, b += dj)
        ++n;
      return n;
    };
    // the highest one is counted from both sides
    return std::max(0, std::min(count(1, 0) + count(-1, 0), count(0, 1) + count(0, -1)) - 1);
  }


  HalfspaceSolution
  solve_on_growing_grid(HalfspaceProblem                          &problem,
                        double                                     approach,
                        double                                     element,
                        const int                                  most,
                        const std::function<void(double, double)> &lay_grid,
                        int                                       &enlargements,
                        std::shared_ptr<HalfspaceKernels>         &kernels)
  {
    constexpr double most_elements    = 50000;
    constexpr int    most_refinements = 5; // by up to twelve each; no contact at all would never end
    int              refinements      = 0;
    problem.motion                    = HalfspaceMotion::none;
    enlargements                      = 0;
    while (true)
      {
        lay_grid(approach, element);
        HalfspaceSolution solution = solve_rolling(problem, kernels);
        const int         n        = elements_across(solution);
        // half as many again as are needed, since so few tell the size of the contact only roughly; the first
        // guess of the approach is that of another load, and the grid over it larger than the contact by far
        const double factor = std::max(n, 1) / (1.5 * least_elements_across),
                     nearer = std::clamp(1.5 * solution.approach, 1e-3 * approach, approach),
                     size   = static_cast<double>(problem.grid.size()) * nearer / approach;
        if (solution.touches_grid_edge && enlargements < most)
          {
            // extents go with the root of the approach: each grid is a fifth longer and wider than the last
            ++enlargements;
            approach *= 1.5;
          }
        else if (n < least_elements_across && size < most_elements * factor * factor &&
                 refinements < most_refinements)
          {
            ++refinements;
            element *= factor;
            approach = nearer;
          }
        else
          return solution;
      }
  }


  HalfspaceSolution
  solve_carried(const HalfspaceProblem            &problem,
                std::shared_ptr<HalfspaceKernels> &kernels,
                const HalfspaceSolution           *guess)
  {
    HalfspaceSolution solution = solve_rolling(problem, kernels, guess);
    if (solution.within_friction)
      return solution;
    HalfspaceProblem sliding         = problem;
    sliding.longitudinal_force_given = false;
    sliding.xi                       = problem.fx < 0 ? 1 : -1;
    solution                         = solve_rolling(sliding, kernels, guess);
    solution.within_friction         = false;
    return solution;
  }


  std::string
  resolution_note(const HalfspaceSettings &scene, const HalfspaceSolution &solution)
  {
    const int    n      = elements_across(solution);
    const double wanted = scene.halfspace_element_size, used = solution.grid.dx;
    if (used > 0.9 * wanted && n >= least_elements_across)
      return "";
    return "Half-space/Element size = " + in_mm(wanted) + ": " +
           (used > 0.9 * wanted
              ? ""
              : "too coarse for this contact, elements of " + in_mm(used, 1e5) + " were taken; ") +
           counted_elements(n) + " across the contact" +
           (n < least_elements_across ? ", too few for results: the peak pressure may be off by 5 % and more"
                                      : "");
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


  double
  wear_number(const HalfspaceProblem &problem, const HalfspaceSolution &solution)
  {
    const HalfspaceBody &a = problem.body1, &b = problem.body2;
    const bool           alike = a.shear_modulus == b.shear_modulus && a.poisson_ratio == b.poisson_ratio;
    return alike && !problem.added ? solution.creepage_work : solution.friction_work;
  }


  WearProfile
  halfspace_wear(const HalfspaceProblem  &problem,
                 const HalfspaceSolution &solution,
                 const double             velocity,
                 const WearData          &data)
  {
    const SlidingPaths paths  = sliding_paths(problem, solution);
    HalfspaceSolution  passed = solution;
    passed.pressure           = paths.pressure;
    passed.traction_x         = paths.traction_x;
    passed.traction_y         = paths.traction_y;
    passed.slip_x             = paths.slip_x;
    passed.slip_y             = paths.slip_y;
    return wear_profile(halfspace_patch(passed), velocity, data);
  }
} // namespace wheelrail
