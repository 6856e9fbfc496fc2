#include <wheelrail/halfspace/sliding_paths.h>

#include <array>
#include <cmath>
#include <cstddef>

// What a particle slides on its path through the contact. It comes from +x and passes from element e + 1 to
// e; over that path it has the mean of both tractions and the slip of e (doc/theory/halfspace.md, T-gamma:
// the sum of elements alone is 14 % too small with 0.5 mm).

namespace wheelrail
{
  namespace
  {
    /// Slip of an element behind the contact, from the displacements here and upstream.
    std::array<double, 2>
    slip_behind(const HalfspaceProblem &problem, const HalfspaceSolution &s, const int i, const int j)
    {
      const auto of = [](const std::vector<double> &field, const std::size_t e) {
        return field.empty() ? 0 : field[e];
      };
      const HalfspaceGrid &grid  = s.grid;
      const std::size_t    e     = i + std::size_t(grid.mx) * j;
      const double         ahead = problem.spin_offset * s.step;
      // s = w + (u - u')/dq of an element without traction, u' at its neighbour upstream, +x; the solution
      // has slips of elements in contact alone
      return {s.xi - s.phi * grid.y(j) + of(problem.rigid_slip_x, e) +
                (s.displacement_x[e] - s.displacement_x[e + 1]) / grid.dx,
              s.eta + s.phi * (grid.x(i) + ahead) + of(problem.rigid_slip_y, e) +
                (s.displacement_y[e] - s.displacement_y[e + 1]) / grid.dx};
    }
  } // namespace


  SlidingPaths
  sliding_paths(const HalfspaceProblem &problem, const HalfspaceSolution &s)
  {
    const HalfspaceGrid &grid = s.grid;
    const std::size_t    n    = grid.size();
    SlidingPaths         paths;
    // path of element e: from the centre of e + 1 to that of e, dx long
    for (auto *field : {&paths.pressure, &paths.traction_x, &paths.traction_y, &paths.slip_x, &paths.slip_y})
      field->assign(n, 0.);
    for (int j = 0; j < grid.my; ++j)
      for (int i = 0; i < grid.mx; ++i)
        {
          const std::size_t e        = i + std::size_t(grid.mx) * j;
          const bool        upstream = i + 1 < grid.mx, here = s.pressure[e] > 0;
          // A particle comes from e + 1 and ends at e: its traction is the mean of both ends, zero outside
          // the contact.
          const auto mean = [&](const std::vector<double> &field) {
            return 0.5 * (field[e] + (upstream ? field[e + 1] : 0));
          };
          if (!here && !(upstream && s.pressure[e + 1] > 0))
            continue;
          paths.pressure[e]   = mean(s.pressure);
          paths.traction_x[e] = mean(s.traction_x);
          paths.traction_y[e] = mean(s.traction_y);
          // the slip of e is that of the path to e: (u - u')/dq counts from the centre upstream
          if (here)
            {
              paths.slip_x[e] = s.slip_x[e];
              paths.slip_y[e] = s.slip_y[e];
            }
          // the trailing edge: half of the traction of the last element slides out over the element behind it
          else if (s.state[e + 1] == HalfspaceSolution::slip && s.friction[e + 1] > 0)
            {
              const auto slip = slip_behind(problem, s, i, j);
              paths.slip_x[e] = slip[0];
              paths.slip_y[e] = slip[1];
            }
        }
    return paths;
  }


  double
  friction_work(const HalfspaceProblem &problem, const HalfspaceSolution &s)
  {
    // a path needs what the element ahead had a step before: in steady rolling what it has now
    if (problem.motion != HalfspaceMotion::steady)
      return std::nan("");
    // mean of the tractions at both ends of a path over an element, and its slip: with u = A t and A
    // symmetric the sum of (t + t') (u - u') vanishes (doc/theory/halfspace.md, T-gamma)
    const SlidingPaths paths = sliding_paths(problem, s);
    double             work  = 0;
    for (std::size_t e = 0; e < paths.slip_x.size(); ++e)
      // -t . s dA, positive; per metre rolled, since slips are over the speed [J/m]
      work -= paths.traction_x[e] * paths.slip_x[e] + paths.traction_y[e] * paths.slip_y[e];
    return work * s.grid.element_area();
  }
} // namespace wheelrail
