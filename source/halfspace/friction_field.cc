#include <wheelrail/halfspace/friction_field.h>

#include <algorithm>
#include <cmath>

// mu of each element from its slip, with memory: what friction falls to takes a distance
// (doc/theory/halfspace.md, Limits; Vollebregt and Schuttelaars 2012). Without memory falling friction may
// have several solutions.

namespace wheelrail
{
  std::vector<double>
  friction_field(const HalfspaceProblem    &problem,
                 const double               step,
                 const VectorField         &slip,
                 const std::vector<double> &pressure)
  {
    const HalfspaceGrid &grid = problem.grid;
    std::vector<double>  friction(grid.size());
    // d mu/dt = -max(v, v_0)/L (mu - mu(v)), v = V |s| the slip speed, L the memory length (Vollebregt and
    // Schuttelaars 2012), solved exactly over the time of one element with mu(v) held: mu = mu(v) + (mu
    // before - mu(v)) exp(-max(v, v_0) dt/L). Explicit steps would overshoot where v dt > L.
    const double time = step / problem.velocity;
    for (int j = 0; j < grid.my; ++j)
      for (int i = grid.mx - 1; i >= 0; --i) // the path of the particles
        {
          const int    e = i + grid.mx * j;
          const double v = problem.velocity * std::hypot(slip[0][e], slip[1][e]);
          friction[e]    = problem.friction_of_row(j).at(v);
          if (problem.memory_length == 0)
            continue;
          // particles run in at the leading edge with the coefficient at rest and go towards -x
          const bool   inside = i + 1 < grid.mx && pressure[e + 1] > 0;
          const double before = inside ? friction[e + 1] : problem.friction_of_row(j).at(0);
          friction[e] += (before - friction[e]) *
                         std::exp(-std::max(v, problem.memory_least_speed) * time / problem.memory_length);
        }
    return friction;
  }
} // namespace wheelrail
