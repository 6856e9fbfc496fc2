#include <wheelrail/halfspace/run_in.h>

// What ran into the contact within a step dq longer than an element: its slip is (u - u_edge)/(share dq),
// u_edge at the leading edge, share the part of dq since then (doc/theory/halfspace.md, Frame and signs), as
// in CONTACT.

namespace wheelrail
{
  std::vector<RunIn>
  elements_run_in(const HalfspaceProblem &problem, const double step, const std::vector<double> &pressure)
  {
    const HalfspaceGrid &grid = problem.grid;
    std::vector<RunIn>   found;
    if (problem.motion == HalfspaceMotion::shift || problem.simplified || step < 1.001 * grid.dx)
      return found;
    for (int j = 0; j < grid.my; ++j)
      for (int i = grid.mx - 1, edge = -1; i >= 0; --i)
        {
          const int e = i + grid.mx * j;
          if (!(pressure[e] > 0))
            edge = e;
          else if (edge >= 0 && i + 2 < grid.mx && (edge - e) * grid.dx < 0.9999 * step)
            found.push_back({e, edge, (edge - e) * grid.dx / step});
        }
    return found;
  }
} // namespace wheelrail
