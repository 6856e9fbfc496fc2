#include <wheelrail/base/errors.h>
#include <wheelrail/contactcalls/call_table.h>
#include <wheelrail/contactcalls/contact_calls.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

// What a contact came to, in the units and signs of the caller.

using namespace wheelrail;

namespace
{
  /// Factors from SI units to those of the caller.
  struct FromSI
  {
    explicit FromSI(const CallUnits &units)
      : length(1e3 / units.length)
      , stress(1e-6 / units.stress)
      , body(units.body)
    {
    }
    double length, stress, body;
  };

  /// Hands over a solved contact.
  template <typename Work>
  void
  with_result(const char *name, const int ire, const int icp, const Work &work)
  {
    with_problem({name, 0, true}, ire, icp, [&](CallElement &element, CallProblem &problem) {
      work(call_result(problem, icp), problem, FromSI(element.units));
    });
  }

  void
  fill(const std::vector<double> &from, const int n, double *to)
  {
    for (int k = 0; k < n; ++k)
      to[k] = std::size_t(k) < from.size() ? from[std::size_t(k)] : 0;
  }

  /// A field by its code (fld_... of CONTACT), one value per element, in SI units without the body's sign.
  std::vector<double>
  field(const int code, const CallResult &solved, const CallProblem &problem)
  {
    const HalfspaceSolution &s = solved.solution;
    // 0 where no layer yields, nothing heats
    const auto where_kept = [&](const std::vector<double> &values) {
      return values.empty() ? std::vector<double>(std::size_t(s.grid.size()), 0.) : values;
    };
    switch (code)
      {
        case 1:
          {
            std::vector<double> h = s.gap; // e = h - approach + u_n
            for (std::size_t e = 0; e < h.size(); ++e)
              h[e] += s.approach - s.displacement_n[e];
            if (problem.solved)
              {
                const CaseProblem task = case_problem(*problem.before);
                h                      = task.problem.undeformed_distance;
                if (task.turned)
                  std::reverse(h.begin(), h.end());
              }
            return h;
          }
        case 2:
          return s.friction;
        case 3:
          return s.traction_x;
        case 4:
          return s.traction_y;
        case 5:
          return s.pressure;
        case 7:
          return s.displacement_x;
        case 8:
          return s.displacement_y;
        case 9:
          return s.displacement_n;
        case 15:
          return s.slip_x;
        case 16:
          return s.slip_y;
        case 11:
          return where_kept(s.yield_stress);
        case 12:
          return where_kept(s.plastic_x);
        case 13:
          return where_kept(s.plastic_y);
        case 20:
        case 21:
          return where_kept(s.temperature[code == 20 ? 0 : 1]);
        default:
          throw InputError("the field " + std::to_string(code) +
                           " is not available; taken are 1 to 5, 7 to 9, 11 to 13, 15, 16, 20 and 21");
      }
  }

  /// The factor to the units and the body of the caller.
  double
  field_unit(const int code, const FromSI &unit, const bool shift)
  {
    switch (code)
      {
        case 1:
        case 7:
        case 8:
        case 9:
        case 12:
        case 13:
          return unit.length;
        case 3:
        case 4:
          return unit.stress * unit.body;
        case 5:
        case 11:
          return unit.stress;
        case 15:
        case 16:
          return unit.body * (shift ? unit.length : 1);
        default:
          return 1;
      }
  }

  void
  get_fields(const char                                  *name,
             const int                                    ire,
             const int                                    icp,
             const int                                    n,
             const std::vector<std::pair<int, double *>> &fields)
  {
    with_result(name, ire, icp, [&](const CallResult &s, const CallProblem &problem, const FromSI &unit) {
      for (const auto &[code, values] : fields)
        {
          const std::vector<double> from   = field(code, s, problem);
          const double              factor = field_unit(code, unit, problem.before->digits.motion == 1);
          for (int k = 0; k < std::min(n, int(from.size())); ++k)
            values[k] = factor * from[std::size_t(k)];
        }
    });
  }
} // namespace

void
cntc_getpenetration(const int *ire, const int *icp, double *approach)
{
  if (faulty(__func__, {ire, icp, approach}))
    return;
  with_result(
    "cntc_getpenetration", *ire, *icp, [&](const CallResult &s, const CallProblem &, const FromSI &unit) {
      *approach = unit.length * s.solution.approach;
    });
}

void
cntc_getcreepages(const int *ire, const int *icp, double *vx, double *vy, double *phi)
{
  if (faulty(__func__, {ire, icp, vx, vy, phi}))
    return;
  with_result("cntc_getcreepages",
              *ire,
              *icp,
              [&](const CallResult &s, const CallProblem &problem, const FromSI &unit) {
                const bool   shift  = problem.before->digits.motion == 1;
                const double factor = unit.body * (shift ? unit.length : 1);
                *vx                 = factor * (s.patch ? s.patch->creepage : s.solution.xi);
                *vy                 = factor * (s.patch ? s.patch->lateral_creepage : s.solution.eta);
                *phi = unit.body * (s.patch ? s.patch->spin : s.solution.phi) / (shift ? 1 : unit.length);
              });
}

void
cntc_getcontactforces(const int *ire, const int *icp, double *fn, double *fx, double *fy, double *mz)
{
  if (faulty(__func__, {ire, icp, fn, fx, fy, mz}))
    return;
  with_result(
    "cntc_getcontactforces", *ire, *icp, [&](const CallResult &s, const CallProblem &, const FromSI &unit) {
      *fn = s.patch ? s.patch->normal_force : s.solution.fn;
      *fx = unit.body * s.solution.fx;
      *fy = unit.body * (s.patch ? s.patch->lateral_force : s.solution.fy);
      *mz = unit.body * unit.length * (s.patch ? s.patch->spin_moment : s.solution.spin_moment);
    });
}

void
cntc_getcontactpatchareas(const int *ire, const int *icp, double *contact, double *adhesion, double *slip)
{
  if (faulty(__func__, {ire, icp, contact, adhesion, slip}))
    return;
  with_result("cntc_getcontactpatchareas",
              *ire,
              *icp,
              [&](const CallResult &s, const CallProblem &, const FromSI &unit) {
                const double area = unit.length * unit.length;
                *contact          = area * s.solution.area;
                *adhesion         = area * s.solution.adhesion_area;
                *slip             = area * s.solution.slip_area;
              });
}

void
cntc_getelementdivision(const int *ire, const int *icp, const int *n, int *states)
{
  if (faulty(__func__, {ire, icp, n, when(n, states)}))
    return;
  with_result(
    "cntc_getelementdivision", *ire, *icp, [&](const CallResult &s, const CallProblem &, const FromSI &) {
      for (int k = 0; k < std::min(*n, s.solution.grid.size()); ++k)
        states[k] = s.solution.state[std::size_t(k)];
    });
}

void
cntc_getmaximumpressure(const int *ire, const int *icp, double *pressure)
{
  if (faulty(__func__, {ire, icp, pressure}))
    return;
  with_result(
    "cntc_getmaximumpressure", *ire, *icp, [&](const CallResult &s, const CallProblem &, const FromSI &unit) {
      *pressure = unit.stress * s.solution.peak_pressure;
    });
}

void
cntc_getmaximumtraction(const int *ire, const int *icp, double *traction)
{
  if (faulty(__func__, {ire, icp, traction}))
    return;
  with_result(
    "cntc_getmaximumtraction", *ire, *icp, [&](const CallResult &s, const CallProblem &, const FromSI &unit) {
      *traction = unit.stress * s.solution.peak_shear;
    });
}

void
cntc_getmaximumtemperature(const int *ire, const int *icp, double *body1, double *body2)
{
  if (faulty(__func__, {ire, icp, body1, body2}))
    return;
  *body1 = *body2 = 0;
  with_result(
    "cntc_getmaximumtemperature", *ire, *icp, [&](const CallResult &s, const CallProblem &, const FromSI &) {
      const auto &of = s.solution.temperature;
      if (of[0].empty())
        throw InputError("temperatures are not asked for; call cntc_settemperaturedata");
      *body1 = *body2 = hottest(s.solution);
    });
}

void
cntc_getfielddata(const int *ire, const int *icp, const int *code, const int *n, double *values)
{
  if (faulty(__func__, {ire, icp, code, n, when(n, values)}))
    return;
  get_fields("cntc_getfielddata", *ire, *icp, *n, {{*code, values}});
}

void
cntc_gettractions(const int *ire, const int *icp, const int *n, double *pn, double *px, double *py)
{
  if (faulty(__func__, {ire, icp, n, when(n, pn), when(n, px), when(n, py)}))
    return;
  get_fields("cntc_gettractions", *ire, *icp, *n, {{5, pn}, {3, px}, {4, py}});
}

void
cntc_getmicroslip(const int *ire, const int *icp, const int *n, double *sx, double *sy)
{
  if (faulty(__func__, {ire, icp, n, when(n, sx), when(n, sy)}))
    return;
  get_fields("cntc_getmicroslip", *ire, *icp, *n, {{15, sx}, {16, sy}});
}

void
cntc_getdisplacements(const int *ire, const int *icp, const int *n, double *un, double *ux, double *uy)
{
  if (faulty(__func__, {ire, icp, n, when(n, un), when(n, ux), when(n, uy)}))
    return;
  get_fields("cntc_getdisplacements", *ire, *icp, *n, {{9, un}, {7, ux}, {8, uy}});
}

void
cntc_getsensitivities(const int *ire, const int *icp, const int *n_out, const int *n_in, double *values)
{
  if (faulty(__func__, {ire, icp, n_out, n_in, when(n_in, values)}))
    return;
  std::fill(values, values + std::max(0, *n_out) * std::max(0, *n_in), 0.);
  with_result(
    "cntc_getsensitivities", *ire, *icp, [](const CallResult &, const CallProblem &, const FromSI &) {
      throw InputError("sensitivities are not computed; solve for changed creepages instead");
    });
}

void
cntc_gethertzcontact(const int *ire, const int *icp, const int *n, double *values)
{
  if (faulty(__func__, {ire, icp, n, when(n, values)}))
    return;
  with_result("cntc_gethertzcontact",
              *ire,
              *icp,
              [&](const CallResult &s, const CallProblem &problem, const FromSI &unit) {
                if (!s.hertz)
                  throw InputError("the contact is no ellipse of Hertz (IPOTCN -6 to -1)");
                const HertzContact &h = *s.hertz;
                const double        l = unit.length;
                fill({h.A / l,
                      h.B / l,
                      h.a * l,
                      h.b * l,
                      2 * l / (h.A + h.B),
                      l * std::sqrt(h.a * h.b),
                      problem.before->grid.values.back(),
                      h.b * l,
                      h.b * l,
                      h.a / h.b},
                     *n,
                     values);
              });
}

void
cntc_getnumelements(const int *ire, const int *icp, int *mx, int *my)
{
  if (faulty(__func__, {ire, icp, mx, my}))
    return;
  *mx = *my = 0;
  with_result(
    "cntc_getnumelements", *ire, *icp, [&](const CallResult &s, const CallProblem &, const FromSI &) {
      *mx = s.solution.grid.mx;
      *my = s.solution.grid.my;
    });
}

void
cntc_getgriddiscretization(const int *ire, const int *icp, double *dx, double *dy)
{
  if (faulty(__func__, {ire, icp, dx, dy}))
    return;
  with_result("cntc_getgriddiscretization",
              *ire,
              *icp,
              [&](const CallResult &s, const CallProblem &, const FromSI &unit) {
                *dx = unit.length * s.solution.grid.dx;
                *dy = unit.length * s.solution.grid.dy;
              });
}

void
cntc_getpotcontact(const int *ire, const int *icp, const int *n, double *values)
{
  if (faulty(__func__, {ire, icp, n, when(n, values)}))
    return;
  with_result(
    "cntc_getpotcontact", *ire, *icp, [&](const CallResult &s, const CallProblem &, const FromSI &unit) {
      const HalfspaceGrid &g = s.solution.grid;
      fill({double(g.mx),
            double(g.my),
            unit.length * g.x0,
            unit.length * g.y0,
            unit.length * g.dx,
            unit.length * g.dy},
           *n,
           values);
    });
}

void
cntc_getreferencevelocity(const int *ire, const int *icp, double *velocity)
{
  if (faulty(__func__, {ire, icp, velocity}))
    return;
  with_problem(
    {"cntc_getreferencevelocity", 0, true}, *ire, *icp, [&](CallElement &element, CallProblem &problem) {
      *velocity = element.module == 3
                    ? problem.one.rolling.velocity / element.units.length
                    : call_result(problem, *icp).patch->velocity / (millimetre * element.units.length);
    });
}
