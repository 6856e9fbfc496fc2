#include <wheelrail/base/errors.h>
#include <wheelrail/contactcalls/call_table.h>
#include <wheelrail/contactcalls/contact_calls.h>
#include <wheelrail/contactfiles/case_checks.h>
#include <wheelrail/contactfiles/case_points.h>

#include <chrono>
#include <string>
#include <vector>

namespace wheelrail
{
  namespace
  {
    double
    cpu_seconds()
    {
      timespec now;
      clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
      return double(now.tv_sec) + 1e-9 * double(now.tv_nsec);
    }

    /// The case as a file would state it.
    ContactCase
    stated_case(const CallProblem &problem)
    {
      ContactCase          one = problem.one;
      const ControlDigits &d   = one.digits;
      if (one.module == 1)
        {
          one.wheelset.position[2] = d.normal == 1 ? problem.normal_force : problem.approach;
          one.wheelset.velocity[5] = d.forces == 1 ? problem.relative_fx : problem.spin;
          return one;
        }
      one.kinematics = {d.normal == 1 ? problem.normal_force : problem.approach,
                        d.forces >= 1 ? problem.relative_fx : problem.creepage_x,
                        d.forces == 2 ? problem.relative_fy : problem.creepage_y,
                        problem.spin,
                        0,
                        0,
                        1};
      return one;
    }

    /// Messages without the line, which calls have none of.
    std::string
    without_line(const ContactCase &one, std::string sentence)
    {
      const std::string place = one.file + ":1: ";
      if (sentence.rfind(place, 0) == 0)
        sentence.erase(0, place.size());
      return "cntc_calculate, " + one.file + ": " + sentence;
    }

    /// A point as CONTACT has it; displacements are not computed.
    std::vector<double>
    columns(const PointStress &p)
    {
      const HalfspaceStress &s    = p.stress;
      constexpr double       none = -999;
      return {p.x,
              p.y,
              p.z,
              none,
              none,
              none,
              p.mean(),
              s.von_mises(),
              p.principal[0] - p.principal[2],
              p.principal[0],
              p.principal[1],
              p.principal[2],
              s.xx,
              s.xy,
              s.xn,
              s.xy,
              s.yy,
              s.yn,
              s.xn,
              s.yn,
              s.nn};
    }

    int
    elements_at_edge(const HalfspaceSolution &s)
    {
      int count = 0;
      for (int j = 0; j < s.grid.my; ++j)
        for (int i = 0; i < s.grid.mx; ++i)
          if ((s.grid.mx > 1 && (i == 0 || i + 1 == s.grid.mx)) ||
              (s.grid.my > 1 && (j == 0 || j + 1 == s.grid.my)))
            count += s.pressure[std::size_t(i + s.grid.mx * j)] > 0 ? 1 : 0;
      return count;
    }

    int
    error_of(const HalfspaceSolution &s)
    {
      return !s.normal_converged       ? call_error::normal
             : !s.within_friction      ? call_error::force
             : !s.tangential_converged ? call_error::tangential
             : !s.converged()          ? call_error::tolerance
                                       : 0;
    }
  } // namespace


  int
  calculate(CallElement &, CallProblem &problem)
  {
    const ContactCase one = stated_case(problem);
    if (one.module == 3 && one.grid.kind == 0)
      {
        call_message(without_line(one, "there is no grid; call cntc_sethertzcontact or cntc_setpotcontact"));
        return call_error::grid;
      }
    try
      {
        check_case(one, problem.before ? &*problem.before : nullptr);
      }
    catch (const InputError &error)
      {
        problem.solved.reset(); // nothing of an earlier contact is taken for this one
        problem.wheel_rail.reset();
        call_message(without_line(one, error.what()));
        return call_error::input;
      }
    problem.state.warm = problem.computed();
    CaseResult result  = solve_next_case(one, problem.state);
    for (const std::string &sentence : result.refused)
      call_message(without_line(one, sentence));
    problem.solved     = std::move(result.solved);
    problem.wheel_rail = std::move(result.wheel_rail);
    problem.below.clear();
    if (!problem.computed())
      return result.refused.empty() ? 0 : call_error::other;
    problem.one.number += 1;
    problem.before = one;
    if (one.module == 1)
      {
        const std::string &missed = problem.wheel_rail->not_reached;
        if (!missed.empty())
          call_message(without_line(one, missed));
        return missed.empty() ? 0 : call_error::tolerance;
      }
    const HalfspaceSolution &s = problem.solved->solution;
    const int                e = error_of(s);
    if (e != 0)
      call_message(without_line(one, s.not_reached));
    return e != 0 ? e : elements_at_edge(s);
  }

  void
  calculate_below(CallProblem &problem)
  {
    problem.below.clear();
    const int patches = problem.solved ? 1 : int(problem.wheel_rail->patches.size());
    for (int patch = 1; patch <= patches; ++patch)
      for (const auto &[number, points] : problem.blocks)
        {
          const HalfspaceSolution &solution = call_result(problem, patch).solution;
          for (const PointStress &p :
               block_stresses(point_block(points, solution.grid), problem.one.material, solution))
            problem.below[{patch, number}].push_back(columns(p));
        }
  }
} // namespace wheelrail

using namespace wheelrail;

void
cntc_calculate(const int *ire, const int *icp, int *error)
{
  if (error)
    *error = call_error::element;
  const int failed =
    with_problem({__func__, ire, icp}, {error}, [&](CallElement &element, CallProblem &problem) {
      const double cpu  = cpu_seconds();
      const auto   wall = std::chrono::steady_clock::now();
      *error            = call_error::other;
      *error            = calculate(element, problem);
      problem.cpu_seconds += cpu_seconds() - cpu;
      problem.wall_seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - wall).count();
    });
  if (failed != 0 && error && *error >= 0)
    *error = call_error::other;
}
