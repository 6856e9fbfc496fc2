#include <wheelrail/base/errors.h>
#include <wheelrail/halfspace/problem.h>

#include <algorithm>
#include <cmath>

// Grids and undeformed distances h(x, y) at the centres of elements [m].

namespace wheelrail
{
  HalfspaceGrid
  centred_grid(const double half_x, const double half_y, const double dx, const double dy)
  {
    if (!(dx > 0 && dy > 0 && half_x > 0 && half_y > 0) || !std::isfinite(half_x / dx + half_y / dy))
      throw InputError(
        "A half-space grid needs positive element lengths and a positive size; found elements of " +
        std::to_string(dx) + " m x " + std::to_string(dy) + " m and half sizes " + std::to_string(half_x) +
        " m x " + std::to_string(half_y) + " m.");
    // 2 nx + 1 elements cover (2 nx + 1) dx >= 2 half_x; 1e-9 keeps round-off from adding one
    const int nx = int(std::ceil(half_x / dx - 0.5 - 1e-9)), ny = int(std::ceil(half_y / dy - 0.5 - 1e-9));
    HalfspaceGrid grid;
    grid.mx = 2 * nx + 1;
    grid.my = 2 * ny + 1;
    grid.dx = dx;
    grid.dy = dy;
    // an odd number each way: one element has its middle at 0
    grid.x0 = -nx * dx;
    grid.y0 = -ny * dy;
    return grid;
  }

  namespace
  {
    /// Whether all that moves, presses and heats is finite, and products of several of it. What is not given
    /// may be NaN.
    bool
    has_finite_numbers(const HalfspaceProblem &problem)
    {
      std::vector<double> numbers{problem.body1.shear_modulus,
                                  problem.body2.shear_modulus,
                                  problem.approach,
                                  problem.normal_force,
                                  problem.velocity,
                                  problem.step,
                                  problem.xi,
                                  problem.eta,
                                  problem.phi,
                                  problem.fx,
                                  problem.fy,
                                  problem.spin_offset,
                                  problem.friction.at_rest,
                                  problem.memory_length,
                                  problem.layer_compliance,
                                  problem.normal_compliance};
      for (const FrictionLaw &law : problem.row_friction)
        numbers.push_back(law.at_rest);
      for (const FrictionOfTemperature &hot : problem.hot_friction)
        numbers.insert(numbers.end(), {hot.from, hot.range, hot.change});
      if (problem.heat)
        for (const std::size_t body : {0, 1})
          numbers.insert(numbers.end(), {problem.heat->far[body], problem.heat->effusivity[body]});
      for (const auto *values : {&problem.rigid_slip_x, &problem.rigid_slip_y, &problem.pressure})
        numbers.insert(numbers.end(), values->begin(), values->end());
      // products of several such numbers have to stay finite, too
      constexpr double most = 1e20;
      // what is not asked for may be NaN, which is not >= the limit
      return std::none_of(numbers.begin(), numbers.end(), [](const double v) { return std::abs(v) >= most; });
    }
  } // namespace

  // Conditions are written as !(x > 0), which NaN fails, too. Temperatures are those of steady rolling (Ertz
  // and Knothe 2002); the state before is taken element by element, so that its grid has to be the same one,
  // moved with the contact.
  void
  check_problem(const HalfspaceProblem &problem)
  {
    const HalfspaceGrid &g = problem.grid;
    const auto refuse      = [](const std::string &text) { throw InputError("Half-space problem: " + text); };
    if (g.mx < 1 || g.my < 1 || !(g.dx > 0) || !(g.dy > 0))
      refuse("the grid needs at least one element in each direction and positive element lengths.");
    const std::size_t n = g.size();
    // given pressures need no distance: there is no normal problem
    if (problem.pressure.empty() && problem.undeformed_distance.size() != n)
      refuse("the undeformed distance has " + std::to_string(problem.undeformed_distance.size()) +
             " values, the grid " + std::to_string(n) + " elements.");
    for (const double h : problem.undeformed_distance)
      if (!std::isfinite(h))
        refuse(
          "the undeformed distance holds a value that is not finite; give elements where no surface lies a "
          "large "
          "distance instead.");
    // rigid slip is over the rolling speed [-]; in a shift a distance [m]
    for (const auto *slip : {&problem.rigid_slip_x, &problem.rigid_slip_y})
      if (!slip->empty() && slip->size() != n)
        refuse("a field of rigid slip has " + std::to_string(slip->size()) + " values, the grid " +
               std::to_string(n) + " elements.");
    // nu = 0.5 is accepted: (1 - nu)/G and nu/G of half-spaces stay finite
    for (const HalfspaceBody &b : {problem.body1, problem.body2})
      if (!(b.shear_modulus > 0) || !(b.poisson_ratio >= 0 && b.poisson_ratio <= 0.5))
        refuse("a body has the shear modulus " + std::to_string(b.shear_modulus) +
               " Pa and Poisson's ratio " + std::to_string(b.poisson_ratio) +
               "; a positive modulus and a ratio from 0 to 0.5 are accepted.");
    if (!problem.pressure.empty() && problem.pressure.size() != n)
      refuse("the given pressure has " + std::to_string(problem.pressure.size()) + " values, the grid " +
             std::to_string(n) + " elements.");
    if (problem.pressure.empty() &&
        (problem.force_given ? !(problem.normal_force > 0) : !std::isfinite(problem.approach)))
      refuse("the normal force must be positive and the approach finite.");
    if (!problem.row_friction.empty() && problem.row_friction.size() != std::size_t(g.my))
      refuse("the rows of the grid and the friction laws of rows differ in number.");
    const bool valid_rows = std::all_of(problem.row_friction.begin(),
                                        problem.row_friction.end(),
                                        [](const FrictionLaw &law) { return law.valid(); });
    if (problem.motion != HalfspaceMotion::none &&
        (!problem.friction.valid() || !valid_rows || !(problem.velocity > 0) || !(problem.step >= 0)))
      refuse(
        "friction coefficients, their decay and the step must not be negative, velocity and half velocity "
        "must be positive.");
    if (!(problem.memory_length >= 0) || !(problem.memory_least_speed > 0) ||
        !(problem.layer_compliance >= 0))
      refuse(
        "the memory length of friction and the compliance of a layer must not be negative, the least "
        "speed of the memory must be positive.");
    if (!has_finite_numbers(problem))
      refuse("forces, creepages, spin, velocity, slip, moduli and temperatures must be finite numbers.");
    if (problem.heat && !(problem.heat->effusivity[0] > 0 && problem.heat->effusivity[1] > 0))
      refuse("bodies that take up heat need a positive effusivity.");
    if (!problem.hot_friction.empty() &&
        (!problem.heat || problem.simplified || problem.motion != HalfspaceMotion::steady))
      refuse("friction depends on temperature in steady rolling with heat only, not in simplified theory.");
    if (problem.lateral_force_given && !problem.longitudinal_force_given)
      refuse("a lateral force can be given only together with the longitudinal one.");
    if (problem.previous && problem.previous->pressure.size() != n)
      refuse("the previous state lies on another grid.");
  }

  std::vector<double>
  sampled_distance(const HalfspaceGrid &grid, const std::function<double(double, double)> &h)
  {
    std::vector<double> distance(grid.size());
    // x fastest: value(i, j) at i + mx j, at the centres of elements
    for (int j = 0; j < grid.my; ++j)
      for (int i = 0; i < grid.mx; ++i)
        distance[i + grid.mx * j] = h(grid.x(i), grid.y(j));
    return distance;
  }
} // namespace wheelrail
