#include <wheelrail/halfspace/doubled_elements.h>
#include <wheelrail/halfspace/kernels.h>

#include <algorithm>
#include <memory>

// What the size of elements makes of a solution: the same problem on means over two by two of them
// (doc/theory/intervals.md, (2) and (3)). With an error of order p in h, f(h) - f(0) = (f(2h) - f(h))/(2^p -
// 1).

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
    doubled(const HalfspaceProblem &problem, const int before)
    {
      const HalfspaceGrid &grid   = problem.grid;
      HalfspaceProblem     coarse = problem;
      // `before` elements beside the grid: 0 or 1, so that pairs begin at an even or at an odd element
      coarse.grid = {(grid.mx + before + 1) / 2,
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
  } // namespace


  std::vector<SolvedProblem>
  on_doubled_elements(const HalfspaceProblem &problem, const HalfspaceSolution &solution)
  {
    // what bodies add has its own grid: half-spaces with the same distance and rigid slip stand for true
    // bodies
    HalfspaceProblem bare = problem;
    bare.added.reset();
    bare.previous = nullptr; // of steady rolling there is no state before
    if (bare.force_given)
      bare.normal_force = solution.fn; // the same load on all
    if (!solution.within_friction)
      // a patch that slides as a whole has its tractions from its pressures
      bare.motion = HalfspaceMotion::none;
    std::vector<SolvedProblem>        solved;
    std::shared_ptr<HalfspaceKernels> kernels;
    // the fine solution of half-spaces, too, so that differences are those of the elements alone
    if (problem.added)
      solved.push_back({bare, solve_rolling(bare, kernels, &solution)});
    else
      solved.push_back({problem, solution});
    // two ways in which doubled elements lie to the edge of the contact: how far both differ is chance, their
    // mean is the size
    for (const int before : {0, 1})
      {
        const HalfspaceProblem coarse = doubled(bare, before);
        solved.push_back({coarse, solve_rolling(coarse)});
      }
    return solved;
  }
} // namespace wheelrail
