#include <wheelrail/base/errors.h>
#include <wheelrail/contactcalls/call_table.h>
#include <wheelrail/contactcalls/contact_calls.h>

#include <cstddef>
#include <string>
#include <vector>

// What a contact problem has taken, and its time.

using namespace wheelrail;

namespace
{
  void
  give(const std::vector<double> &from, const int n, double *to)
  {
    for (int k = 0; k < n; ++k)
      to[k] = std::size_t(k) < from.size() ? from[std::size_t(k)] : 0;
  }
} // namespace

void
cntc_getcalculationtime(const int *ire, const int *icp, double *cpu, double *wall)
{
  with_problem({__func__, ire, icp}, {cleared(cpu), cleared(wall)}, [&](CallElement &, CallProblem &problem) {
    *cpu  = problem.cpu_seconds;
    *wall = problem.wall_seconds;
  });
}

void
cntc_resetcalculationtime(const int *ire, const int *icp)
{
  with_problem({__func__, ire, icp}, {}, [](CallElement &, CallProblem &problem) {
    problem.cpu_seconds = problem.wall_seconds = 0;
  });
}

void
cntc_getparameters(const int *ire, const int *icp, const int *task, const int *n, double *values)
{
  with_problem(
    {__func__, ire, icp}, {task, n, when(n, values)}, [&](CallElement &element, CallProblem &problem) {
      const ContactCase         &one   = problem.one;
      const CallUnits           &u     = element.units;
      const ContactMaterial     &m     = one.material;
      const std::vector<double> &c     = m.constants;
      const bool                 layer = m.constants_of == 4;
      if (*task == 1)
        give({one.rolling.velocity / u.length,
              one.rolling.direction,
              one.rolling.step / u.length,
              one.kinematics.spin_x / u.length,
              one.kinematics.spin_y / u.length,
              layer ? c[2] / u.stress : 0},
             *n,
             values);
      else if (*task == 2)
        {
          const double G  = 2 / (1 / m.shear[0] + 1 / m.shear[1]);
          const double nu = G * (m.poisson[0] / m.shear[0] + m.poisson[1] / m.shear[1]) / 2;
          give({m.shear[0] / u.stress, m.shear[1] / u.stress, G / u.stress, m.poisson[0], m.poisson[1], nu},
               *n,
               values);
        }
      else if (*task == 3)
        {
          std::vector<double> all{double(one.digits.law),
                                  double(one.friction.lines.size()),
                                  one.friction.memory_length / u.length,
                                  one.friction.memory_speed / u.length};
          for (const ContactFrictionLine &line : one.friction.lines)
            {
              const std::vector<double> &v     = line.constants;
              const bool                 falls = one.digits.law >= 2 && one.digits.law <= 4;
              all.insert(all.end(), {line.place, falls ? v[0] + v[1] + v[3] : v[0], v[0]});
            }
          give(all, *n, values);
        }
      else
        {
          give({}, *n, values);
          throw InputError("the task " + std::to_string(*task) + " is unknown; 1 to 3 are known");
        }
    });
}
