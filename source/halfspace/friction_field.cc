#include <wheelrail/halfspace/friction_field.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

// mu of each element from its slip, with memory: what friction falls to takes a distance
// (doc/theory/halfspace.md, Limits; Vollebregt and Schuttelaars 2012). Without memory falling friction may
// have several solutions.

namespace wheelrail
{
  double
  friction_of_particle(const HalfspaceProblem &problem,
                       const double            law,
                       const double            velocity,
                       const double            ahead,
                       const double            step)
  {
    if (problem.memory_length == 0)
      return law;
    // d mu/dt = -max(v, v_0)/L (mu - mu(v)), v = V |s| the slip speed, L the memory length (Vollebregt and
    // Schuttelaars 2012), solved exactly over the time of one element with mu(v) held: mu = mu(v) + (mu
    // before - mu(v)) exp(-max(v, v_0) dt/L). Explicit steps would overshoot where v dt > L.
    const double rate = std::max(velocity, problem.memory_least_speed) / problem.memory_length;
    return law + (ahead - law) * std::exp(-rate * step / problem.velocity);
  }

  double
  hot_friction(const HalfspaceProblem &problem, const int j, const double temperature)
  {
    // friction never falls to 0: 1e-6 is left, as in CONTACT
    const auto &hot = problem.hot_friction;
    if (hot.empty())
      return 0;
    const double change = (hot.size() > 1 ? hot[std::size_t(j)] : hot.front()).at(temperature);
    return std::max(change, 1e-6 - problem.friction_of_row(j).at(0));
  }

  std::vector<double>
  friction_field(const HalfspaceProblem    &problem,
                 const double               step,
                 const VectorField         &slip,
                 const std::vector<double> &pressure,
                 const std::vector<double> &temperature)
  {
    const HalfspaceGrid           &grid   = problem.grid;
    const HalfspaceSolution *const before = problem.previous;
    const bool                     steady = problem.motion == HalfspaceMotion::steady,
               goes_on                    = before && before->friction.size() == std::size_t(grid.size());
    const int from                        = problem.motion == HalfspaceMotion::shift ? 0 : 1;
    // one pass from the leading edge: the coefficient of an element follows from that of the one ahead
    std::vector<double> friction(grid.size());
    for (int j = 0; j < grid.my; ++j)
      for (int i = grid.mx - 1; i >= 0; --i) // the path of the particles
        {
          const int e = i + grid.mx * j;
          // particles run in at the leading edge with the coefficient at rest and go towards -x; a step
          // brings that of the state before, a shift leaves them where they are
          const bool within = i + from < grid.mx;
          double     ahead  = problem.friction_of_row(j).at(0);
          if (steady && within && pressure[e + 1] > 0)
            ahead = friction[e + 1];
          else if (!steady && goes_on && within && before->pressure[e + from] > 0)
            ahead = before->friction[e + from];
          const double velocity = problem.velocity * std::hypot(slip[0][e], slip[1][e]);
          const bool   hot      = !temperature.empty();
          const double law =
            problem.friction_of_row(j).at(velocity) + (hot ? hot_friction(problem, j, temperature[e]) : 0);
          // CONTACT lets temperature work at the least speed of the memory alone
          friction[e] = friction_of_particle(problem, law, hot ? 0 : velocity, ahead, step);
        }
    return friction;
  }
} // namespace wheelrail
