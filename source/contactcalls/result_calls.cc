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
  /// A solved contact, and factors from SI units to those of the caller.
  struct Solved : CallResult
  {
    const CallProblem &problem;
    double             length, stress;
    int                body;
  };

  template <typename Work>
  void
  with_result(const CallFor &call, const std::vector<CallArgument> &arguments, const Work &work)
  {
    with_problem(
      {call.name, call.ire, call.icp, 0, true}, arguments, [&](CallElement &element, CallProblem &problem) {
        const CallUnits &units = element.units;
        work(Solved{
          call_result(problem, *call.icp), problem, 1e3 / units.length, 1e-6 / units.stress, units.body});
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
  field_unit(const int code, const Solved &s)
  {
    switch (code)
      {
        case 1:
        case 7:
        case 8:
        case 9:
        case 12:
        case 13:
          return s.length;
        case 3:
        case 4:
          return s.stress * s.body;
        case 5:
        case 11:
          return s.stress;
        case 15:
        case 16:
          return s.body * (s.problem.before->digits.motion == 1 ? s.length : 1);
        default:
          return 1;
      }
  }

  void
  copy_field(const int code, const Solved &s, const int n, double *values)
  {
    const std::vector<double> from   = field(code, s, s.problem);
    const double              factor = field_unit(code, s);
    for (int k = 0; k < std::min(n, int(from.size())); ++k)
      values[k] = factor * from[std::size_t(k)];
  }

  /// Fields by their codes.
  void
  get_fields(const CallFor &call, const int *n, const std::vector<std::pair<int, double *>> &fields)
  {
    std::vector<CallArgument> arguments{n};
    for (const auto &field : fields)
      arguments.push_back(when(n, field.second));
    with_result(call, arguments, [&](const Solved &s) {
      for (const auto &[code, values] : fields)
        copy_field(code, s, *n, values);
    });
  }
} // namespace

void
cntc_getpenetration(const int *ire, const int *icp, double *approach)
{
  with_result(
    {__func__, ire, icp}, {approach}, [&](const Solved &s) { *approach = s.length * s.solution.approach; });
}

void
cntc_getcreepages(const int *ire, const int *icp, double *vx, double *vy, double *phi)
{
  with_result({__func__, ire, icp}, {vx, vy, phi}, [&](const Solved &s) {
    const bool   shift  = s.problem.before->digits.motion == 1;
    const double factor = s.body * (shift ? s.length : 1);
    *vx                 = factor * (s.patch ? s.patch->creepage : s.solution.xi);
    *vy                 = factor * (s.patch ? s.patch->lateral_creepage : s.solution.eta);
    *phi                = s.body * (s.patch ? s.patch->spin : s.solution.phi) / (shift ? 1 : s.length);
  });
}

void
cntc_getcontactforces(const int *ire, const int *icp, double *fn, double *fx, double *fy, double *mz)
{
  with_result({__func__, ire, icp}, {fn, fx, fy, mz}, [&](const Solved &s) {
    *fn = s.patch ? s.patch->normal_force : s.solution.fn;
    *fx = s.body * s.solution.fx;
    *fy = s.body * (s.patch ? s.patch->lateral_force : s.solution.fy);
    *mz = s.body * s.length * (s.patch ? s.patch->spin_moment : s.solution.spin_moment);
  });
}

void
cntc_getcontactpatchareas(const int *ire, const int *icp, double *contact, double *adhesion, double *slip)
{
  with_result({__func__, ire, icp}, {contact, adhesion, slip}, [&](const Solved &s) {
    const double area = s.length * s.length;
    *contact          = area * s.solution.area;
    *adhesion         = area * s.solution.adhesion_area;
    *slip             = area * s.solution.slip_area;
  });
}

void
cntc_getelementdivision(const int *ire, const int *icp, const int *n, int *states)
{
  with_result({__func__, ire, icp}, {n, when(n, states)}, [&](const Solved &s) {
    for (int k = 0; k < std::min(*n, s.solution.grid.size()); ++k)
      states[k] = s.solution.state[std::size_t(k)];
  });
}

void
cntc_getmaximumpressure(const int *ire, const int *icp, double *pressure)
{
  with_result({__func__, ire, icp}, {pressure}, [&](const Solved &s) {
    *pressure = s.stress * s.solution.peak_pressure;
  });
}

void
cntc_getmaximumtraction(const int *ire, const int *icp, double *traction)
{
  with_result(
    {__func__, ire, icp}, {traction}, [&](const Solved &s) { *traction = s.stress * s.solution.peak_shear; });
}

void
cntc_getmaximumtemperature(const int *ire, const int *icp, double *body1, double *body2)
{
  with_result({__func__, ire, icp}, {cleared(body1), cleared(body2)}, [&](const Solved &s) {
    const auto &of = s.solution.temperature;
    if (of[0].empty())
      throw InputError("temperatures are not asked for; call cntc_settemperaturedata");
    *body1 = *body2 = hottest(s.solution);
  });
}

void
cntc_getfielddata(const int *ire, const int *icp, const int *code, const int *n, double *values)
{
  with_result({__func__, ire, icp}, {code, n, when(n, values)}, [&](const Solved &s) {
    copy_field(*code, s, *n, values);
  });
}

void
cntc_gettractions(const int *ire, const int *icp, const int *n, double *pn, double *px, double *py)
{
  get_fields({__func__, ire, icp}, n, {{5, pn}, {3, px}, {4, py}});
}

void
cntc_getmicroslip(const int *ire, const int *icp, const int *n, double *sx, double *sy)
{
  get_fields({__func__, ire, icp}, n, {{15, sx}, {16, sy}});
}

void
cntc_getdisplacements(const int *ire, const int *icp, const int *n, double *un, double *ux, double *uy)
{
  get_fields({__func__, ire, icp}, n, {{9, un}, {7, ux}, {8, uy}});
}

void
cntc_getsensitivities(const int *ire, const int *icp, const int *n_out, const int *n_in, double *values)
{
  const int all = n_out && n_in ? std::max(0, *n_out) * std::max(0, *n_in) : 0;
  with_result({__func__, ire, icp}, {n_out, n_in, cleared(&all, values)}, [](const Solved &) {
    throw InputError("sensitivities are not computed; solve for changed creepages instead");
  });
}

void
cntc_gethertzcontact(const int *ire, const int *icp, const int *n, double *values)
{
  with_result({__func__, ire, icp}, {n, when(n, values)}, [&](const Solved &s) {
    if (!s.hertz)
      throw InputError("the contact is no ellipse of Hertz (IPOTCN -6 to -1)");
    const HertzContact &h = *s.hertz;
    const double        l = s.length;
    fill({h.A / l,
          h.B / l,
          h.a * l,
          h.b * l,
          2 * l / (h.A + h.B),
          l * std::sqrt(h.a * h.b),
          s.problem.before->grid.values.back(),
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
  with_result({__func__, ire, icp}, {cleared(mx), cleared(my)}, [&](const Solved &s) {
    *mx = s.solution.grid.mx;
    *my = s.solution.grid.my;
  });
}

void
cntc_getgriddiscretization(const int *ire, const int *icp, double *dx, double *dy)
{
  with_result({__func__, ire, icp}, {dx, dy}, [&](const Solved &s) {
    *dx = s.length * s.solution.grid.dx;
    *dy = s.length * s.solution.grid.dy;
  });
}

void
cntc_getpotcontact(const int *ire, const int *icp, const int *n, double *values)
{
  with_result({__func__, ire, icp}, {n, when(n, values)}, [&](const Solved &s) {
    const HalfspaceGrid &g = s.solution.grid;
    fill({double(g.mx), double(g.my), s.length * g.x0, s.length * g.y0, s.length * g.dx, s.length * g.dy},
         *n,
         values);
  });
}

void
cntc_getreferencevelocity(const int *ire, const int *icp, double *velocity)
{
  with_result({__func__, ire, icp}, {velocity}, [&](const Solved &s) {
    *velocity = s.length * (s.patch ? s.patch->velocity : millimetre * s.problem.one.rolling.velocity);
  });
}
