#include <wheelrail/halfspace/kernels.h>
#include <wheelrail/halfspace/problem.h>
#include <wheelrail/output/figures.h>
#include <wheelrail/sampling/creep_scale.h>
#include <wheelrail/wheel/contact_intervals.h>
#include <wheelrail/wheel/halfspace_parts.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

// What the size of elements makes of a solution: the same problem on means over two by two of them
// (doc/theory/intervals.md, (2) and (3)). With an error of order p in h, f(h) - f(0) = (f(2h) - f(h))/(2^p -
// 1).

namespace wheelrail
{
  namespace
  {
    struct SolvedProblem
    {
      HalfspaceProblem  problem;
      HalfspaceSolution solution;
    };

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

    /// A problem and, twice, the same on means over two by two elements, whose edges lie in two ways to those
    /// of the contact: what the size of elements makes of a solution (Richardson's extrapolation). All
    /// without what bodies add, whose influence has its own grid, so that of true bodies half-spaces with the
    /// same distance and rigid slip are compared; without rolling where the patch slides as a whole.
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
      // two ways in which doubled elements lie to the edge of the contact: how far both differ is chance,
      // their mean is the size
      for (const int before : {0, 1})
        {
          const HalfspaceProblem coarse = doubled(bare, before);
          solved.push_back({coarse, solve_rolling(coarse)});
        }
      return solved;
    }

    /// A result of elements.
    struct ElementResult
    {
      std::string name;
      double      value; ///< [SI]
      bool   creep;   ///< errs with the first power of the element size, else with the second, or by chance
      double scale;   ///< that is natural to it [SI]
      double floor;   ///< spread times the elements across the patch, over the scale
      double own = 0; ///< the same over the result itself
    };

    /// Results of one patch, forces those on the wheel. The floors are
    /// found from random contacts whose elements were halved, see doc/theory/intervals.md.
    std::vector<ElementResult>
    element_results(const SolvedProblem &solved, const WheelRailSolution &patch)
    {
      const HalfspaceProblem    &problem  = solved.problem;
      const HalfspaceSolution   &s        = solved.solution;
      const PatchMeasures        measures = measure_patch(halfspace_patch(s));
      const double               peak = s.peak_pressure, length = measures.length, width = measures.width;
      std::vector<ElementResult> results{
        {"max_pressure", peak, false, peak, 0.1},
        {"max_pressure_fitted", measures.peak_pressure_fitted, false, peak, 0.1},
        {"contact_area", measures.area, false, measures.area, 0.2},
        {"patch_lateral", width, false, width, 0.3},
        {"patch_longitudinal", length, false, length, 0.45},
        problem.force_given ? ElementResult{"approach", s.approach, false, s.approach, 0.15}
                            : ElementResult{"normal_force", s.fn, false, s.fn, 0.1}};
      if (problem.friction.frictionless()) // it follows from the mean angle over the pressure
        results.push_back({"lateral_force", patch.lateral, false, patch.lateral, 0.1});
      if (problem.motion != HalfspaceMotion::steady || problem.friction.frictionless())
        return results;
      const double bound = problem.friction.at(0) * s.fn, creep = half_saturation(problem, s, measures);
      results.push_back(
        {"max_shear_traction", measures.max_traction, false, problem.friction.at(0) * peak, 1.0});
      results.push_back({"stick_fraction", measures.stick_fraction, true, 1, 0.8});
      results.push_back({"t_gamma", wear_number(problem, s), true, bound * creep, 0.07, 0.2});
      results.push_back({"lateral_force", -std::cos(patch.angle) * s.fy, true, bound, 0.2});
      if (problem.longitudinal_force_given)
        results.push_back({"creepage", s.xi, true, creep, 0.35});
      else
        results.push_back({"longitudinal_force", -s.fx, true, bound, 0.2});
      return results;
    }
  } // namespace


  double
  half_saturation(const HalfspaceProblem  &problem,
                  const HalfspaceSolution &solution,
                  const PatchMeasures     &patch)
  {
    return creep_scale(problem.friction.at(0) * solution.fn,
                       2 / (1 / problem.body1.shear_modulus + 1 / problem.body2.shear_modulus),
                       patch.length,
                       patch.width)
      .half_saturation();
  }


  Contributions
  element_contributions(const WheelRailSolution &patch)
  {
    const std::vector<SolvedProblem>        solved = on_doubled_elements(patch.problem, patch.solution);
    std::vector<std::vector<ElementResult>> results;
    for (const SolvedProblem &one : solved)
      results.push_back(element_results(one, patch));
    const double across = std::min(patch.measures.width, patch.measures.length) / patch.solution.grid.dx;
    // a ridge is narrower than the patch
    const double  across_peak = std::clamp(patch.measures.cells_across, 1., std::max(1., across));
    Contributions contributions;
    for (const ElementResult &fine : results[0])
      {
        std::vector<double> changes;
        for (std::size_t c = 1; c < solved.size(); ++c)
          // what slides as a whole is no measure of creep, and may have no results of it
          if (!fine.creep || (solved[0].solution.within_friction && solved[c].solution.within_friction))
            for (const ElementResult &coarse : results[c])
              if (coarse.name == fine.name)
                changes.push_back(coarse.value - fine.value);
        if (changes.empty())
          continue;
        const auto [least, most] = std::minmax_element(changes.begin(), changes.end());
        const double mean = 0.5 * (*least + *most), largest = std::max(std::abs(*least), std::abs(*most));
        const double n = fine.name.find("max_pressure") == 0 ? across_peak : across;
        if (fine.creep) // how the elements happen to lie says how well the line towards none is known
          contributions.push_back(
            {fine.name, "elements", -mean, changes.size() > 1 ? *most - *least : largest});
        else
          contributions.push_back({fine.name, "elements", 0, 0.5 * largest});
        contributions.push_back({fine.name,
                                 "place of elements",
                                 0,
                                 std::hypot(fine.floor * fine.scale, fine.own * fine.value) / n});
      }
    return contributions;
  }


  Contributions
  noise_contributions(const NoiseEffect &noise, const Summary &results, const double half)
  {
    constexpr double felt = 2e-3; // of the peak pressure
    if (std::isnan(noise.peak))
      return {};
    Contributions contributions;
    const auto    add = [&](const char *name, const double share, const double least = 0) {
      const double value = get_figure(results, figure_named(name).key());
      if (std::isfinite(value))
        contributions.push_back({name, "measured input", 0, share * std::max(std::abs(value), least)});
    };
    add("max_pressure", noise.peak);
    add("max_pressure_fitted", noise.peak);
    add("max_shear_traction", noise.peak);
    add("contact_area", noise.area);
    add("patch_lateral", noise.width);
    add("patch_longitudinal", noise.length);
    add("approach", noise.approach);
    add("creepage", noise.area, std::isfinite(half) ? half : 0);
    add("t_gamma", noise.area);
    if (noise.peak > felt)
      for (const char *name : {"lateral_force", "stick_fraction"})
        add(name, std::numeric_limits<double>::infinity());
    return contributions;
  }


  Contributions
  without_results(Contributions contributions, const std::vector<std::string> &results)
  {
    contributions.erase(std::remove_if(contributions.begin(),
                                       contributions.end(),
                                       [&](const Contribution &one) {
                                         return std::find(results.begin(), results.end(), one.result) !=
                                                results.end();
                                       }),
                        contributions.end());
    return contributions;
  }


  Contributions
  joined_contributions(const std::vector<Contributions> &of_patches,
                       const std::vector<Summary>       &patches,
                       const Summary                    &total)
  {
    Contributions joined;
    for (std::size_t k = 0; k < patches.size(); ++k)
      for (const Contribution &one : of_patches[k])
        {
          const std::string key  = figure_named(one.result).key();
          const bool        sums = one.result == "contact_area" || one.result == "t_gamma" ||
                            one.result.find("_force") != std::string::npos;
          if (!sums && get_figure(patches[k], key) != get_figure(total, key))
            continue;
          const auto same = std::find_if(joined.begin(), joined.end(), [&](const Contribution &other) {
            return other.result == one.result && other.cause == one.cause;
          });
          if (same == joined.end())
            joined.push_back(one);
          else if (sums)
            {
              same->shift += one.shift;
              same->spread += one.spread;
            }
        }
    return joined;
  }
} // namespace wheelrail
