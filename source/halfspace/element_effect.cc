#include <wheelrail/halfspace/element_effect.h>

#include <algorithm>
#include <cmath>
#include <vector>

// What elements of twice the size change (Richardson's extrapolation): an error of first order is the change
// itself.

namespace wheelrail
{
  namespace
  {
    /// Means over two by two elements, the first of which begin `before` the grid; those beyond it are as its
    /// outermost ones.
    std::vector<double>
    halved(const HalfspaceGrid       &grid,
           const HalfspaceGrid       &coarse,
           const int                  before,
           const std::vector<double> &values)
    {
      std::vector<double> means;
      if (values.empty())
        return means;
      const auto at = [&](const int i, const int j) {
        return values[std::clamp(i - before, 0, grid.mx - 1) +
                      grid.mx * std::clamp(j - before, 0, grid.my - 1)];
      };
      for (int j = 0; j < 2 * coarse.my; j += 2)
        for (int i = 0; i < 2 * coarse.mx; i += 2)
          // tractions are constant on elements, so that distance and rigid slip act by their means
          means.push_back(0.25 * (at(i, j) + at(i + 1, j) + at(i, j + 1) + at(i + 1, j + 1)));
      return means;
    }

    HalfspaceProblem
    on_doubled_elements(const HalfspaceProblem &problem, const int before)
    {
      const HalfspaceGrid &grid   = problem.grid;
      HalfspaceProblem     coarse = problem;
      coarse.grid                 = {(grid.mx + before + 1) / 2,
                                     (grid.my + before + 1) / 2,
                                     2 * grid.dx,
                                     2 * grid.dy,
                                     // the middle of a doubled element lies half an element off
                                     grid.x0 + (0.5 - before) * grid.dx,
                                     grid.y0 + (0.5 - before) * grid.dy};
      for (auto *const field :
           {&coarse.undeformed_distance, &coarse.normal_cosine, &coarse.rigid_slip_x, &coarse.rigid_slip_y})
        *field = halved(grid, coarse.grid, before, *field);
      return coarse;
    }

    double
    relative(const double difference, const double value, const double least)
    {
      return std::abs(difference) / std::max(std::abs(value), least);
    }
  } // namespace


  ElementEffect
  element_effect(const HalfspaceProblem &problem, const HalfspaceSolution &solution, const bool rolls)
  {
    // below it neither creepage nor force matters: of the creepage, and of what friction carries
    constexpr double  least_creepage = 2e-5, least_force = 0.01;
    HalfspaceProblem  bare = problem;
    HalfspaceSolution alone;
    // half-spaces without what bodies add, whose influence has its own grid; of steady rolling no state
    // before
    bare.added.reset();
    bare.previous = nullptr;
    if (bare.force_given)
      // the same load on both
      bare.normal_force = solution.fn;
    if (!rolls || !solution.within_friction)
      bare.motion = HalfspaceMotion::none;
    if (problem.added)
      alone = solve_rolling(bare);
    const HalfspaceSolution &fine     = problem.added ? alone : solution;
    const double             friction = bare.friction.at(0) * fine.fn;
    ElementEffect            effect;
    // how elements lie to the edge of the contact scatters: the worse one of two grids
    for (const int before : {0, 1})
      {
        const HalfspaceSolution coarse = solve_rolling(on_doubled_elements(bare, before));
        // errors of order h^p: f(2h) - f(h) = (2^p - 1) times the error at h, so that the difference is the
        // error itself for p = 1 (creepage, forces) and three times it for p = 2 (smooth pressure);
        // Richardson
        effect.pressure =
          std::max({effect.pressure,
                    relative(coarse.peak_pressure - fine.peak_pressure, fine.peak_pressure, 1),
                    // with a given approach the force is the result
                    relative(coarse.fn - fine.fn, fine.fn, 1)});
        if (bare.motion == HalfspaceMotion::none || bare.friction.frictionless() || !coarse.within_friction ||
            !fine.within_friction)
          continue;
        effect.creep = std::max(effect.creep,
                                relative(std::hypot(coarse.fx - fine.fx, coarse.fy - fine.fy),
                                         std::hypot(fine.fx, fine.fy),
                                         least_force * friction));
        if (bare.longitudinal_force_given)
          effect.creep = std::max(effect.creep, relative(coarse.xi - fine.xi, fine.xi, least_creepage));
      }
    return effect;
  }
} // namespace wheelrail
