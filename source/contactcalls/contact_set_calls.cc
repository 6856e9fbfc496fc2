#include <wheelrail/base/errors.h>
#include <wheelrail/contactcalls/call_table.h>
#include <wheelrail/contactcalls/contact_calls.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

// Rolling, grid, undeformed distance, forces and creepages.

using namespace wheelrail;

namespace
{
  /// Values with powers of the length, one letter each: l length, c curvature, - number.
  std::vector<double>
  in_millimetres(const double *values, const std::string &kinds, const CallUnits &units)
  {
    std::vector<double> result;
    for (std::size_t k = 0; k < kinds.size(); ++k)
      result.push_back(values[k] * (kinds[k] == 'l' ? units.length : kinds[k] == 'c' ? 1 / units.length : 1));
    return result;
  }

  void
  set_grid(ContactCase       &one,
           const int          kind,
           const std::string &kinds,
           const int          n,
           const double      *values,
           const CallUnits   &units)
  {
    if (n != int(kinds.size()) + 2)
      throw InputError("IPOTCN = " + std::to_string(kind) + " needs " + std::to_string(kinds.size() + 2) +
                       " values, not " + std::to_string(n));
    ContactGrid grid;
    grid.kind                    = kind;
    grid.mx                      = int(std::lround(values[0]));
    grid.my                      = int(std::lround(values[1]));
    grid.values                  = in_millimetres(values + 2, kinds, units);
    grid.line                    = 1;
    const std::vector<double> &v = grid.values;
    if (const std::string fault = grid.fault_of_size(); !fault.empty())
      throw InputError(fault);
    if (kind < 0 ? !(*std::min_element(v.begin(), v.end()) > 0)
                 : !(grid.corner()[2] > 0) || !(grid.corner()[3] > 0) ||
                     !std::isfinite(grid.corner()[2] + grid.corner()[3]))
      throw InputError("IPOTCN = " + std::to_string(kind) + ": a size is not positive");
    one.grid = grid;
  }
} // namespace

void
cntc_settimestep(const int *ire, const int *icp, const double *)
{
  // for damping alone, which is not computed
  with_problem({__func__, ire, icp}, {}, [](CallElement &, CallProblem &) {});
}

void
cntc_setreferencevelocity(const int *ire, const int *icp, const double *velocity)
{
  with_problem({__func__, ire, icp, 3}, {velocity}, [&](CallElement &element, CallProblem &problem) {
    problem.one.rolling.velocity = std::max(1e-9, std::abs(*velocity) * element.units.length);
  });
}

void
cntc_setrollingstepsize(const int *ire, const int *icp, const double *chi, const double *dq)
{
  with_problem({__func__, ire, icp}, {chi, dq}, [&](CallElement &element, CallProblem &problem) {
    if (element.module == 1)
      {
        problem.one.elements.relative_step = *dq;
        return;
      }
    problem.one.rolling.direction = *chi;
    problem.one.rolling.step      = *dq * element.units.length;
  });
}

void
cntc_sethertzcontact(const int *ire, const int *icp, const int *ipotcn, const int *n, const double *values)
{
  with_problem(
    {__func__, ire, icp, 3}, {ipotcn, n, when(n, values)}, [&](CallElement &element, CallProblem &problem) {
      const char *const kinds[] = {"cc-", "c--", "ll-", "cl-", "ll-", "lll-"}; // of -1, -2, ... -6
      if (*ipotcn < -6 || *ipotcn > -1)
        throw InputError("IPOTCN = " + std::to_string(*ipotcn) + " is unknown; -6 to -1 are ellipses");
      set_grid(problem.one, *ipotcn, kinds[-1 - *ipotcn], *n, values, element.units);
      if (*ipotcn == -4 || *ipotcn == -5) // elliptic pressure along x, as CONTACT's library sets it
        problem.one.digits.bound = 2;
    });
}

void
cntc_setpotcontact(const int *ire, const int *icp, const int *ipotcn, const int *n, const double *values)
{
  with_problem(
    {__func__, ire, icp}, {ipotcn, n, when(n, values)}, [&](CallElement &element, CallProblem &problem) {
      const CallUnits &units = element.units;
      if (element.module == 3)
        {
          if (*ipotcn < 1 || *ipotcn > 4)
            throw InputError("IPOTCN = " + std::to_string(*ipotcn) + " is unknown; 1 to 4 are grids");
          return set_grid(problem.one, *ipotcn, "llll", *n, values, units);
        }
      ContactElements &elements = problem.one.elements;
      if ((*ipotcn != 0 && *ipotcn != -1) || (*ipotcn == 0 && *n != 3) ||
          (*ipotcn == -1 && (*n < 5 || *n > 7)))
        throw InputError("module 1 takes IPOTCN = -1 with 5 to 7 values and 0 with 3, not " +
                         std::to_string(*ipotcn) + " with " + std::to_string(*n));
      elements.dx   = values[0] * units.length;
      elements.ds   = values[1] * units.length;
      elements.line = 1;
      if (!(elements.dx > 0) || !(elements.ds > 0))
        throw InputError("the elements' sizes DX, DS are not positive");
      if (*ipotcn == 0)
        return;
      elements.a_sep      = values[2];
      elements.d_sep      = values[3] * units.length;
      elements.d_comb     = values[4] * units.length;
      elements.d_turn     = *n > 5 ? values[5] * units.length : 2 * elements.d_sep - elements.d_comb;
      elements.missed_gap = *n > 6 ? values[6] * units.length : -1;
    });
}

void
cntc_setundeformeddistc(const int *ire, const int *icp, const int *ibase, const int *n, const double *values)
{
  with_problem(
    {__func__, ire, icp, 3}, {ibase, n, when(n, values)}, [&](CallElement &element, CallProblem &problem) {
      ContactDistance distance;
      distance.base     = *ibase;
      distance.line     = 1;
      const auto needed = [&](const double count) {
        if (*n != count)
          throw InputError("IBASE = " + std::to_string(*ibase) + " needs " + std::to_string(int(count)) +
                           " values, not " + std::to_string(*n));
      };
      switch (*ibase)
        {
          case 1:
            needed(6);
            distance.values = in_millimetres(values, "ccc--l", element.units);
            break;
          case 2:
            needed(*n > 0 ? 5 + std::round(values[0]) : 7);
            if (values[0] < 2 || !(values[4] > 0) || values[2] == 0)
              throw InputError("IBASE = 2 needs two heights or more, a positive step DY1 and a radius RM");
            distance.values =
              in_millimetres(values + 1, std::string(std::size_t(*n - 1), 'l'), element.units);
            break;
          case 3:
            needed(8);
            distance.values = in_millimetres(values, "lcllclll", element.units);
            if (distance.values[6] == 0 || distance.values[7] == 0)
              throw InputError("B7 or B8 of IBASE = 3 is 0; x and y squared are divided by them");
            break;
          case 9:
            needed(double(problem.one.grid.mx) * problem.one.grid.my);
            distance.values = in_millimetres(values, std::string(std::size_t(*n), 'l'), element.units);
            break;
          default:
            throw InputError("IBASE = " + std::to_string(*ibase) + " is unknown; 1, 2, 3 and 9 are known");
        }
      problem.one.distance = distance;
    });
}

void
cntc_setverticalforce(const int *ire, const double *fz)
{
  with_problem({__func__, ire, &whole, 1}, {fz}, [&](CallElement &, CallProblem &problem) {
    problem.one.digits.normal = 1;
    problem.normal_force      = *fz;
  });
}

void
cntc_setpenetration(const int *ire, const int *icp, const double *approach)
{
  with_problem({__func__, ire, icp, 3}, {approach}, [&](CallElement &element, CallProblem &problem) {
    problem.one.digits.normal = 0;
    problem.approach          = *approach * element.units.length;
  });
}

void
cntc_setnormalforce(const int *ire, const int *icp, const double *fn)
{
  with_problem({__func__, ire, icp, 3}, {fn}, [&](CallElement &, CallProblem &problem) {
    if (*fn < 0)
      throw InputError("the normal force is negative; a force that presses counts positive");
    problem.one.digits.normal = 1;
    problem.normal_force      = *fn;
  });
}

void
cntc_settangentialforces(const int *ire, const int *icp, const double *fx, const double *fy)
{
  with_problem({__func__, ire, icp}, {fx, fy}, [&](CallElement &element, CallProblem &problem) {
    // module 3: over friction times normal force, cut to 1; module 1: FX_WS in N
    const double size   = std::hypot(*fx, *fy);
    const double factor = element.module == 3 && size > 1 ? 1 / size : 1;
    problem.relative_fx = factor * *fx;
    problem.relative_fy = factor * *fy;
  });
}

void
cntc_setcreepages(const int *ire, const int *icp, const double *vx, const double *vy, const double *phi)
{
  with_problem({__func__, ire, icp, 3}, {vx, vy, phi}, [&](CallElement &element, CallProblem &problem) {
    const bool shift   = problem.one.digits.motion == 1;
    problem.creepage_x = *vx * (shift ? element.units.length : 1);
    problem.creepage_y = *vy * (shift ? element.units.length : 1);
    problem.spin       = *phi / (shift ? 1 : element.units.length);
  });
}

void
cntc_setextrarigidslip(const int *ire, const int *icp, const int *n, const double *wx, const double *wy)
{
  with_problem(
    {__func__, ire, icp, 3}, {n, when(n, wx), when(n, wy)}, [&](CallElement &, CallProblem &problem) {
      if (*n != problem.one.grid.mx * problem.one.grid.my)
        throw InputError("the extra rigid slip needs a value of each element, " +
                         std::to_string(problem.one.grid.mx * problem.one.grid.my) + ", not " +
                         std::to_string(*n));
      problem.one.digits.extra = 9;
      problem.one.extra_slip   = {{wx, wx + *n}, {wy, wy + *n}, 1};
    });
}
