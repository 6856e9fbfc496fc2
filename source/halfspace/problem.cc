#include <wheelrail/base/errors.h>
#include <wheelrail/halfspace/problem.h>

#include <cmath>

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
    const int nx = int(std::ceil(half_x / dx - 0.5 - 1e-9)), ny = int(std::ceil(half_y / dy - 0.5 - 1e-9));
    HalfspaceGrid grid;
    grid.mx = 2 * nx + 1;
    grid.my = 2 * ny + 1;
    grid.dx = dx;
    grid.dy = dy;
    grid.x0 = -nx * dx;
    grid.y0 = -ny * dy;
    return grid;
  }

  double
  friction_coefficient(const HalfspaceFriction &friction, const double slip_velocity)
  {
    const double v = slip_velocity / friction.velocity_scale, mu = friction.kinetic_coefficient,
                 drop = friction.static_coefficient - mu;
    switch (friction.law)
      {
        case HalfspaceFriction::Law::rational:
          return mu + drop / (1 + v);
        case HalfspaceFriction::Law::exponential:
          return mu + drop * std::exp(-v);
        default:
          return friction.static_coefficient;
      }
  }

  std::vector<double>
  sampled_distance(const HalfspaceGrid &grid, const std::function<double(double, double)> &h)
  {
    std::vector<double> distance(grid.size());
    for (int j = 0; j < grid.my; ++j)
      for (int i = 0; i < grid.mx; ++i)
        distance[i + grid.mx * j] = h(grid.x(i), grid.y(j));
    return distance;
  }

  std::vector<double>
  quadratic_distance(const HalfspaceGrid &grid, const double rx, const double ry)
  {
    return sampled_distance(grid, [&](double x, double y) { return x * x / (2 * rx) + y * y / (2 * ry); });
  }
} // namespace wheelrail
