#include <wheelrail/halfspace/contact_heat.h>
#include <wheelrail/halfspace/problem.h>
#include <wheelrail/halfspace/tangential.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

// Flash temperatures of a rolling contact: Ertz and Knothe, Wear 253 (2002), on Carslaw and Jaeger (1959).

namespace wheelrail
{
  double
  FrictionOfTemperature::at(const double temperature) const
  {
    // a straight line between `from` and `from + range`, as in CONTACT
    return change * std::clamp((temperature - from) / range, 0., 1.);
  }


  std::array<std::vector<double>, 2>
  surface_temperatures(const HeatConduction      &bodies,
                       const HalfspaceGrid       &grid,
                       const double               velocity,
                       const std::vector<double> &pressure,
                       const std::vector<double> &heat)
  {
    // Heat flows into the depth alone: at speed the surface has passed before it spreads sideways (Ertz and
    // Knothe 2002).
    const double b1 = bodies.effusivity[0], b2 = bodies.effusivity[1];
    // two half-spaces that meet: (b1 T1 + b2 T2)/(b1 + b2), b the effusivity (Carslaw and Jaeger 1959)
    const double met = (b1 * bodies.far[0] + b2 * bodies.far[1]) / (b1 + b2);
    // heat q on both for the time x/V: 2 q sqrt(x / (pi V)) / (b1 + b2)
    const double        rise = 2 / ((b1 + b2) * std::sqrt(M_PI * velocity)), half = 0.5 * grid.dx;
    std::vector<double> reach(std::size_t(grid.mx)); // of an element on one so many behind it
    for (int k = 0; k < grid.mx; ++k)
      // [K m2/W]: temperature at the distance of k elements behind one under the heat q [W/m2]; the element's
      // own counts twice, as in CONTACT
      reach[std::size_t(k)] =
        rise * (k == 0 ? 2 * std::sqrt(half) : std::sqrt(k * grid.dx + half) - std::sqrt(k * grid.dx - half));
    std::array<std::vector<double>, 2> found;
    for (int body = 0; body < 2; ++body)
      // [deg C]; what has not touched has its own temperature
      found[std::size_t(body)].assign(std::size_t(grid.size()), bodies.far[std::size_t(body)]);
    for (int j = 0; j < grid.my; ++j)
      {
        const auto row   = std::size_t(grid.mx) * std::size_t(j);
        int        first = grid.mx, last = -1;
        for (int i = 0; i < grid.mx; ++i)
          if (pressure[row + std::size_t(i)] > 0)
            {
              first = std::min(first, i);
              last  = i;
            }
        // every row of elements by itself, from its own leading edge
        const double length = (last - first + 1) * grid.dx;
        // from the leading edge against x: ahead of it nothing has been heated
        for (int i = last; i >= 0; --i)
          {
            double friction = 0;
            for (int k = last; k >= i; --k)
              // sum of q_k (sqrt(x + dx/2) - sqrt(x - dx/2)) 2/((b1 + b2) sqrt(pi V)) over the elements ahead
              friction += heat[row + std::size_t(k)] * reach[std::size_t(k - i)];
            // behind the contact: what is left of the exchange between the bodies, 2/pi asin(sqrt(L/x)) of it
            // at the distance x from where it began (Ertz and Knothe 2002)
            const double along  = (last - i + 0.5) * grid.dx;
            const double shared = i >= first ? 1 : 2 / M_PI * std::asin(std::sqrt(length / along));
            for (const std::size_t body : {0, 1})
              {
                // touching: the common temperature; behind the contact each body goes back to its own
                const double own     = bodies.far[body];
                const bool   touches = pressure[row + std::size_t(i)] > 0;
                found[body][row + std::size_t(i)] =
                  own + (i < first || touches ? shared * (met - own) : 0) + friction;
              }
          }
      }
    return found;
  }


  std::array<std::vector<double>, 2>
  temperatures_in_rolling(const HalfspaceProblem    &problem,
                          const std::vector<double> &pressure,
                          const TangentialState     &tangential)
  {
    std::vector<double> heat(std::size_t(problem.grid.size()), 0.); // what the tractions do a second [W/m2]
    // both bodies share the heat by their effusivities, since their surfaces have one temperature
    for (std::size_t e = 0; e < heat.size() && !tangential.slip[0].empty(); ++e)
      {
        const double yields = tangential.plastic.empty() ? 0 : tangential.plastic[e];
        // |t| |s| V; of what the layer does by yielding, a share becomes heat
        heat[e] = std::hypot(tangential.traction[0][e], tangential.traction[1][e]) *
                  std::hypot(tangential.slip[0][e], tangential.slip[1][e]) * problem.velocity *
                  (1 - yields + yields * problem.heat->plastic_share);
      }
    return surface_temperatures(*problem.heat, problem.grid, problem.velocity, pressure, heat);
  }


  double
  hottest(const HalfspaceSolution &solution)
  {
    // NaN where no element is in contact: std::fmax passes over it
    double largest = std::nan("");
    for (const std::vector<double> &body : solution.temperature)
      for (std::size_t e = 0; e < body.size(); ++e)
        if (solution.pressure[e] > 0)
          largest = std::fmax(largest, body[e]);
    return largest;
  }
} // namespace wheelrail
