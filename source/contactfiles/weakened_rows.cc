#include <wheelrail/contactfiles/weakened_rows.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace wheelrail
{
  namespace
  {
    /// The part of each row.
    std::vector<std::size_t>
    parts_of(const HalfspaceGrid &grid, const std::vector<RowDivision> &divisions)
    {
      std::vector<std::size_t> parts;
      for (int j = 0; j < grid.my; ++j)
        {
          std::size_t part = 0;
          while (part < divisions.size() && grid.y(j) > divisions[part].place)
            ++part;
          parts.push_back(part);
        }
      return parts;
    }

    /// What is missing of the normal displacements under the tractions of other parts: the factors less one
    /// times the influence.
    std::vector<double>
    missing_displacements(const HalfspaceSolution        &solution,
                          const std::vector<RowDivision> &divisions,
                          HalfspaceKernels               &kernels)
    {
      const HalfspaceGrid           &grid  = solution.grid;
      const std::vector<std::size_t> parts = parts_of(grid, divisions);
      const auto                     n     = std::size_t(grid.size());
      std::vector<double>            missing(n, 0.);
      const std::vector<double>      none(n, 0.);
      for (std::size_t from = 0; from <= divisions.size(); ++from)
        {
          std::vector<double> own = none;
          for (std::size_t e = 0; e < n; ++e)
            if (parts[e / std::size_t(grid.mx)] == from)
              own[e] = solution.pressure[e];
          const std::vector<double> moved = displacements(kernels, {2}, {&none, &none, &own}).front();
          for (std::size_t e = 0; e < n; ++e)
            if (const std::size_t to = parts[e / std::size_t(grid.mx)]; to != from)
              {
                const bool beside = to + 1 == from || from + 1 == to;
                missing[e] += ((beside ? divisions[std::min(to, from)].factor : 0) - 1) * moved[e];
              }
        }
      return missing;
    }
  } // namespace


  HalfspaceSolution
  solve_weakened(HalfspaceProblem                   problem,
                 const std::vector<RowDivision>    &divisions,
                 std::shared_ptr<HalfspaceKernels> &kernels,
                 const HalfspaceSolution           *guess)
  {
    const std::vector<double> distance = problem.undeformed_distance;
    HalfspaceSolution         solution = solve_rolling(problem, kernels, guess);
    std::vector<double>       last(distance.size(), 0.);
    for (int round = 0; round < 30; ++round)
      {
        const std::vector<double> missing = missing_displacements(solution, divisions, *kernels);
        double                    change  = 0;
        for (std::size_t e = 0; e < distance.size(); ++e)
          {
            change                         = std::max(change, std::abs(missing[e] - last[e]));
            problem.undeformed_distance[e] = distance[e] + missing[e];
          }
        if (change < 1e-5 * std::abs(solution.approach))
          break;
        last     = missing;
        solution = solve_rolling(problem, kernels, &solution);
      }
    return solution;
  }
} // namespace wheelrail
