#include <wheelrail/halfspace/plastic_layer.h>

// A layer that yields in shear at |t| = tau_c and hardens with the length of its plastic displacement u_p:
// t + h s = g n while it does (doc/theory/halfspace.md, Algorithms; CONTACT's M = 4).

namespace wheelrail
{
  namespace
  {
    /// The element in which the material of element e was a step before; -1: beside the grid.
    int
    element_before(const HalfspaceProblem &problem, const int e)
    {
      // material runs towards -x: one step ago it was one element ahead; in a shift it stays
      if (problem.motion == HalfspaceMotion::shift)
        return e;
      return e % problem.grid.mx + 1 < problem.grid.mx ? e + 1 : -1;
    }
  } // namespace


  std::vector<double>
  brought_yield(const HalfspaceProblem &problem)
  {
    // no layer, or one that never yields
    if (problem.layer_yield == 0)
      return {};
    const std::size_t n = problem.grid.size();
    // yield stress of each element's material as the step begins [Pa]: fresh, or what the state before has
    // made of it
    std::vector<double> yield(n, problem.layer_yield);
    const bool          goes_on = problem.motion != HalfspaceMotion::steady && problem.previous &&
                         problem.previous->yield_stress.size() == n;
    for (std::size_t e = 0; goes_on && e < n; ++e)
      if (const int k = element_before(problem, int(e));
          k >= 0 && problem.previous->yield_stress[std::size_t(k)] > 0)
        yield[e] = problem.previous->yield_stress[std::size_t(k)];
    return yield;
  }


  void
  set_layer_state(const HalfspaceProblem &problem,
                  const TangentialState  &tangential,
                  HalfspaceSolution      &solution)
  {
    HalfspaceSolution &s = solution;
    const std::size_t  n = problem.grid.size();
    if (problem.layer_yield == 0 || tangential.plastic.size() != n)
      return;
    const bool shift  = problem.motion == HalfspaceMotion::shift,
               steady = problem.motion == HalfspaceMotion::steady;
    // what has left the contact forgets: fresh material rolls in
    s.yield_stress = tangential.yield;
    s.plastic_x.assign(n, 0.);
    s.plastic_y.assign(n, 0.);
    const bool goes_on = problem.previous && problem.previous->plastic_x.size() == n;
    // in steady rolling the state a step before is that of the element ahead, which this loop has passed
    const HalfspaceSolution *const old = steady ? &s : goes_on ? problem.previous : nullptr;
    // from large x down, the path of the material
    for (std::size_t e = n; e-- > 0;)
      {
        const bool touches = s.pressure[e] > 0;
        // what has rolled out leaves its yield stress and plastic shift behind
        if (!touches && !shift)
          {
            s.yield_stress[e] = problem.layer_yield;
            continue;
          }
        // against the slip that it takes the place of
        const int before = element_before(problem, int(e));
        if (old && before >= 0)
          {
            s.plastic_x[e] = old->plastic_x[std::size_t(before)];
            s.plastic_y[e] = old->plastic_y[std::size_t(before)];
          }
        // 1 where the layer takes all of the slip, 0 where the surfaces slide
        const double share = tangential.plastic[e];
        // u_p = u_p(a step before) - share h s, s the slip over the step h; what is left of it slides
        s.plastic_x[e] -= share * s.step * s.slip_x[e];
        s.plastic_y[e] -= share * s.step * s.slip_y[e];
        s.slip_x[e] *= 1 - share;
        s.slip_y[e] *= 1 - share;
      }
  }
} // namespace wheelrail
