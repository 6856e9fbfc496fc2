#include <wheelrail/contactfiles/case_grid.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>

namespace wheelrail
{
  namespace
  {
    /// The heights of IBASE = 2 between their points, on straight lines that go on outside [mm].
    double
    profile_height(const std::vector<double> &values, const double y)
    {
      const double first = values[2], step = values[3];
      const double place = (y - first) / step;
      const auto   last  = double(values.size() - 4) - 2;
      const auto   k     = std::size_t(std::clamp(std::floor(place), 0., last));
      const double left = values[4 + k], right = values[5 + k];
      return left + (right - left) * (place - double(k));
    }

    /// Undeformed distance at a place, all in mm.
    std::function<double(double, double)>
    distance_of(const ContactDistance &given)
    {
      const std::vector<double> &v = given.values;
      if (given.base == 1)
        return [&v](const double x, const double y) {
          return v[0] * x * x + v[1] * x * y + v[2] * y * y + v[3] * x + v[4] * y + v[5];
        };
      if (given.base == 2)
        return [&v](const double x, const double y) {
          return profile_height(v, y) + (x - v[0]) * (x - v[0]) / (2 * v[1]);
        };
      return [&v](const double x, const double y) {
        return v[0] * std::sin(v[1] * (x - v[2])) - v[3] * std::sin(v[4] * (x - v[5])) + x * x / v[6] +
               y * y / v[7];
      };
    }

    /// Whether an element may touch (IPLAN).
    bool
    within_planform(const ContactDistance &given, const double x, const double y)
    {
      const std::vector<double> &v = given.plan;
      if (given.planform == 2)
        return v[0] * x * x + v[1] * x * y + v[2] * y * y + v[3] * x + v[4] * y + v[5] < 0;
      const auto inside = [&](const std::size_t k) {
        return x >= v[k] && x <= v[k + 1] && y >= v[k + 2] && y <= v[k + 3];
      };
      return given.planform != 3 || inside(0) || inside(4);
    }
  } // namespace


  HalfspaceGrid
  grid_of(const ContactGrid &given, const std::optional<HertzContact> &hertz)
  {
    HalfspaceGrid grid;
    grid.mx = given.mx;
    grid.my = given.my;
    double x, y; // the corner
    if (hertz)
      {
        const double scale = given.values.back();
        x                  = -scale * hertz->a;
        grid.dx            = -2 * x / grid.mx;
        grid.dy            = 2 * scale * hertz->b / grid.my;
        if (given.kind <= -4) // whole rows in the strip, the others to both sides
          grid.dy = 2 * hertz->b / given.rows_of_strip();
        y = -0.5 * grid.my * grid.dy;
      }
    else
      {
        const std::array<double, 4> corner = given.corner();
        x                                  = millimetre * corner[0];
        y                                  = millimetre * corner[1];
        grid.dx                            = millimetre * corner[2];
        grid.dy                            = millimetre * corner[3];
      }
    grid.x0 = x + 0.5 * grid.dx;
    grid.y0 = y + 0.5 * grid.dy;
    return grid;
  }

  std::vector<double>
  distances(const ContactCase &one, const HalfspaceGrid &grid, const std::optional<HertzContact> &hertz)
  {
    if (hertz)
      return sampled_distance(grid, [&](double x, double y) { return hertz->A * x * x + hertz->B * y * y; });
    std::vector<double> h;
    if (one.distance.base == 9)
      for (const double value : one.distance.values)
        h.push_back(millimetre * value);
    else
      h = sampled_distance(grid, [at = distance_of(one.distance)](double x, double y) {
        return millimetre * at(x / millimetre, y / millimetre);
      });
    constexpr double far_apart = 1; // [m]
    for (int j = 0; j < grid.my; ++j)
      for (int i = 0; i < grid.mx; ++i)
        if (!within_planform(one.distance, grid.x(i) / millimetre, grid.y(j) / millimetre))
          h[i + grid.mx * j] = far_apart;
    return h;
  }
} // namespace wheelrail
