#include <wheelrail/base/errors.h>
#include <wheelrail/base/interrupt.h>
#include <wheelrail/contactfiles/case_checks.h>
#include <wheelrail/contactfiles/solve_cases.h>
#include <wheelrail/halfspace/turned_rows.h>
#include <wheelrail/tables/text_rows.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <utility>

namespace wheelrail
{
  void
  turn_solution(HalfspaceSolution &solution)
  {
    solution.grid = turned_grid(solution.grid);
    for (auto *field : {&solution.pressure,
                        &solution.traction_x,
                        &solution.traction_y,
                        &solution.displacement_n,
                        &solution.displacement_x,
                        &solution.displacement_y,
                        &solution.gap,
                        &solution.slip_x,
                        &solution.slip_y,
                        &solution.friction,
                        &solution.yield_stress,
                        &solution.plastic_x,
                        &solution.plastic_y,
                        &solution.temperature[0],
                        &solution.temperature[1]})
      std::reverse(field->begin(), field->end());
    std::reverse(solution.state.begin(), solution.state.end());
    for (auto *field : {&solution.traction_x,
                        &solution.traction_y,
                        &solution.displacement_x,
                        &solution.displacement_y,
                        &solution.slip_x,
                        &solution.slip_y,
                        &solution.plastic_x,
                        &solution.plastic_y})
      for (double &value : *field)
        value = -value;
    for (double *value : {&solution.fx, &solution.fy, &solution.xi, &solution.eta})
      *value = -*value;
  }


  HalfspaceSolution
  on_grid(const HalfspaceSolution &state, const HalfspaceGrid &grid)
  {
    const int         right = int(std::lround((grid.x0 - state.grid.x0) / grid.dx));
    const int         up    = int(std::lround((grid.y0 - state.grid.y0) / grid.dy));
    HalfspaceSolution moved;
    moved.grid = grid;
    const std::array<std::pair<std::vector<double> *, const std::vector<double> *>, 7> fields{
      {{&moved.pressure, &state.pressure},
       {&moved.traction_x, &state.traction_x},
       {&moved.traction_y, &state.traction_y},
       {&moved.friction, &state.friction},
       {&moved.yield_stress, &state.yield_stress},
       {&moved.plastic_x, &state.plastic_x},
       {&moved.plastic_y, &state.plastic_y}}};
    for (const auto &[to, from] : fields)
      {
        to->assign(std::size_t(grid.size()), 0.);
        for (int j = 0; !from->empty() && j < grid.my; ++j)
          for (int i = 0; i < grid.mx; ++i)
            if (const int k = i + right, l = j + up;
                k >= 0 && k < state.grid.mx && l >= 0 && l < state.grid.my)
              (*to)[i + grid.mx * j] = (*from)[k + state.grid.mx * l];
      }
    return moved;
  }


  CaseSolution
  solve_case(const ContactCase &one, const HalfspaceSolution *previous, CaseState &state)
  {
    CaseProblem       task    = case_problem(one);
    HalfspaceProblem &problem = task.problem;
    CaseSolution      result;
    HalfspaceSolution before, guess;
    const auto        in_axes = [&](const HalfspaceSolution &other) {
      HalfspaceSolution turned = other;
      if (task.turned)
        turn_solution(turned);
      return turned;
    };
    if (previous)
      {
        before           = on_grid(in_axes(*previous), problem.grid);
        problem.previous = &before;
      }
    const bool warm = state.warm && state.last;
    if (warm)
      guess = in_axes(*state.last);
    const auto solve = [&](const HalfspaceProblem &asked) {
      const HalfspaceSolution *const start = warm ? &guess : nullptr;
      return task.angles.empty()
               ? solve_rolling(asked, state.kernels, start)
               : solve_turned(asked, task.angles, one.iteration.maxout, state.kernels, start);
    };
    if (!problem.force_given && problem.longitudinal_force_given)
      {
        HalfspaceProblem normal = problem;
        normal.motion           = HalfspaceMotion::none;
        double       force      = solve(normal).fn;
        const double sign       = task.turned ? -1 : 1;
        for (int round = 0; round < 30; ++round)
          {
            problem.fx      = sign * task.relative_x * task.friction * force;
            problem.fy      = sign * task.relative_y * task.friction * force;
            result.solution = solve(problem);
            if (std::abs(result.solution.fn - force) <= 1e-6 * force)
              break;
            force = result.solution.fn;
          }
      }
    else
      result.solution = solve(problem);
    if (problem.max_coupling_rounds == 1)
      {
        result.solution.coupling_converged = true;
        if (result.solution.normal_converged && result.solution.tangential_converged &&
            result.solution.within_friction)
          result.solution.not_reached.clear();
      }
    if (task.turned)
      turn_solution(result.solution);
    if (!problem.pressure.empty())
      result.solution.approach = task.hertz->approach;
    result.hertz = task.hertz;
    return result;
  }

  CaseSolution
  solve_case(const ContactCase &one, const HalfspaceSolution *previous)
  {
    CaseState state;
    return solve_case(one, previous, state);
  }


  namespace
  {
    /// Whether a step is longer than an element.
    bool
    takes_several_elements(const ContactCase &one)
    {
      if (one.module == 1)
        return (one.digits.motion == 2 || (one.digits.motion == 3 && one.digits.solver == 2)) &&
               one.elements.relative_step > 1.001;
      const HalfspaceProblem problem = case_problem(one).problem;
      return problem.step > 1.001 * problem.grid.dx;
    }

    void
    forget_tractions(HalfspaceSolution &solution)
    {
      for (auto *field : {&solution.traction_x, &solution.traction_y})
        std::fill(field->begin(), field->end(), 0.);
    }

    void
    forget_tractions(WheelRailCase &solved)
    {
      for (WheelRailPatch &patch : solved.patches)
        forget_tractions(patch.solution);
    }

    /// The state from which a case goes on: that before the last case, or its result.
    template <typename State>
    std::optional<State>
    state_before(const std::optional<State> &before, const std::optional<State> &last, const int past)
    {
      if (past == 2)
        return {};
      if (past == 3)
        return before;
      std::optional<State> state = last;
      if (state && past == 1)
        forget_tractions(*state);
      return state;
    }

    void
    solve_on(const ContactCase &one, const bool goes_on, CaseState &state, CaseResult &result)
    {
      const int past = one.digits.past;
      if (one.module == 3)
        {
          auto before           = state_before(state.before, state.last, past);
          result.solved         = solve_case(one, goes_on && before ? &*before : nullptr, state);
          state.before          = std::move(before);
          state.last            = result.solved->solution;
          result.solved->points = case_stresses(one, *state.last);
          return;
        }
      auto before          = state_before(state.before_wheel, state.last_wheel, past);
      state.start.guess    = state.warm && state.last_wheel ? &*state.last_wheel : nullptr;
      WheelRailCase solved = solve_wheel_rail(one, goes_on && before ? &*before : nullptr, state.start);
      if (!solved.refused.empty())
        {
          result.refused.push_back(place(one.file, one.line) + solved.refused);
          return;
        }
      for (WheelRailPatch &patch : solved.patches)
        patch.points = case_stresses(one, patch.solution);
      state.before_wheel = std::move(before);
      state.last_wheel   = solved;
      result.wheel_rail  = std::move(solved);
    }
  } // namespace


  CaseResult
  solve_next_case(const ContactCase &one, CaseState &state)
  {
    CaseResult result;
    const bool goes_on = (one.digits.motion == 1 || one.digits.motion == 2) && one.digits.past != 2;
    result.refused     = refusals(one);
    if (goes_on && !state.known)
      result.refused.push_back(
        place(one.file, one.line) +
        "the case goes on from one before that is not computed; taken are cases with P = 2");
    if (result.refused.empty() && (one.digits.law != 0 || one.digits.material == 4) &&
        takes_several_elements(one))
      result.refused.push_back(
        place(one.file, one.module == 1 ? one.elements.line : one.rolling.line) +
        "DQ > DX (steps of several elements) with L = " + std::to_string(one.digits.law) + " and M = " +
        std::to_string(one.digits.material) + " is not computed; taken are DQ = DX, and L = 0 with M = 0");
    if (result.refused.empty() && one.digits.after < 2)
      try
        {
          solve_on(one, goes_on, state, result);
        }
      catch (const InputError &error) // of a profile, which it names, or of the half-spaces
        {
          const std::string said = error.what();
          result.refused.push_back((said.rfind("Half-space", 0) == 0 ? place(one.file, one.line) : "") +
                                   said);
        }
    state.known = (state.known || !goes_on) && result.refused.empty();
    return result;
  }

  std::vector<CaseResult>
  solve_cases(const std::vector<ContactCase> &cases)
  {
    std::map<std::array<int, 3>, CaseState> states;
    std::vector<CaseResult>                 results;
    try
      {
        for (const ContactCase &one : cases)
          results.push_back(solve_next_case(one, states[{{one.module, one.element, one.problem}}]));
      }
    catch (const Interrupted &)
      {
      }
    return results;
  }
} // namespace wheelrail
